// A compact convex set of R^n known by its support function h(u) = max u.x and support mapping
// s(u), a point at which that maximum is attained ([GFE] Eq. 17).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pdg {

// Immutable; any number of threads may ask it at once, and no question allocates in up to
// `kScratchDimension` dimensions.
//
// What a set promises about rounding, per coordinate i and for every u: the computed point lies
// within `error()[i]` of some point of the set in each coordinate i, and the computed value within
// sum_i |u_i| error()[i] of h(u), the set being the exact one that the input doubles describe.
class ConvexSet {
 public:
  virtual ~ConvexSet() = default;
  ConvexSet(const ConvexSet&) = delete;
  ConvexSet& operator=(const ConvexSet&) = delete;

  // h(u). u has dimension() coordinates and any length; h(0) = 0.
  [[nodiscard]] virtual double value(std::span<const double> u) const = 0;
  // Adds s(u) to `point`, part by part, and returns h(u). For u = 0 any point. error() is that of a
  // point that starts from zeros.
  virtual double add_support(std::span<const double> u, std::span<double> point) const = 0;

  [[nodiscard]] std::size_t dimension() const { return magnitude_.size(); }
  // Per coordinate: bounds |x_i| over the set.
  [[nodiscard]] std::span<const double> magnitude() const { return magnitude_; }
  [[nodiscard]] std::span<const double> error() const { return error_; }

 protected:
  // magnitude and error as above, of equal size.
  ConvexSet(std::vector<double> magnitude, std::vector<double> error);

 private:
  std::vector<double> magnitude_;
  std::vector<double> error_;
};

using SetPointer = std::shared_ptr<const ConvexSet>;

// s(u) into `point`; returns h(u).
inline double support(const ConvexSet& set, const std::span<const double> u,
                      const std::span<double> point) {
  std::ranges::fill(point, 0.0);
  return set.add_support(u, point);
}

// Error bounds of a set whose points are made of `terms` rounded operations on numbers of the given
// magnitude (kSupportErrorUnits of tolerances.hpp).
std::vector<double> rounding_error(std::span<const double> magnitude, std::size_t terms);

inline constexpr std::size_t kScratchDimension = 16;

// Working memory of a composite set: on the stack in up to kScratchDimension dimensions.
class Scratch {
 public:
  explicit Scratch(const std::size_t size)
      : heap_(size > kScratchDimension ? size : 0),
        view_(size > kScratchDimension ? heap_.data() : stack_.data(), size) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::span<double> span() { return view_; }

 private:
  std::array<double, kScratchDimension> stack_{};
  std::vector<double> heap_;
  std::span<double> view_;
};

}  // namespace pdg
