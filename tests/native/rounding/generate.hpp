// Inputs of the rounding harness: random ones, and ones made to hurt.
#pragma once

#include <cstdint>
#include <random>

#include "pdg/native/geometry/polygon.hpp"
#include "planar_planner/native/configurations/dyadic_box.hpp"

namespace rounding {

using pdg::ConvexPolygon;
using pdg::Vec2;

// The same numbers with every standard library.
class Random {
 public:
  explicit Random(const std::uint64_t seed) : engine_(seed) {}
  std::uint64_t bits() { return engine_(); }
  double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
  double between(const double low, const double high) { return low + (high - low) * unit(); }
  // Evenly in the logarithm.
  double magnitude(double low, double high);
  int pick(const int low, const int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(const int n) { return pick(1, n) == 1; }
  double sign() { return one_in(2) ? 1.0 : -1.0; }

 private:
  std::mt19937_64 engine_;
};

// x moved by `steps` units in its last place.
double nudged(double x, int steps);

// Exactly.
bool strictly_convex(const ConvexPolygon& p);

enum class Shape : std::uint8_t {
  kRound,      // vertices near an ellipse
  kSliver,     // a triangle or quadrilateral 1e-12 or so as thick as it is long
  kRectangle,  // axis-parallel, of dyadic coordinates: ties
  kTrapezoid,  // nearly parallel sides, off by 1e-16 .. 1e-6
  kBlunt,      // vertices a few ulps apart
  kSmall,      // 1e-9 of the size
  kCount,
};

// A strictly convex counter-clockwise polygon about `centre`.
ConvexPolygon polygon(Random& random, Shape shape, double size, Vec2 centre);
Shape any_shape(Random& random, bool adversarial);

// Two pieces and the space of configurations that they are judged in; user's frame.
struct PairCase {
  ConvexPolygon a, b;
  pdg::Frame frame;
  planner::CellSpace space;
  std::array<std::uint64_t, 3> target{};  // a configuration, as dyadic coordinates
};

// Adversarial: at the target the pieces touch up to a few rounding errors.
PairCase pair_case(Random& random, bool adversarial);

// The cell of these levels that holds the target.
planner::CellBox cell_at(const std::array<std::uint64_t, 3>& target,
                         const std::array<int, 3>& levels);

}  // namespace rounding
