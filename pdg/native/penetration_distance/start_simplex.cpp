#include "start_simplex.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "nearest_in_hull.hpp"
#include "pdg/native/convex_sets/vectors.hpp"
#include "pdg/native/tolerances.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

using View = std::span<const double>;

// Orthonormal directions found so far.
class Basis {
 public:
  explicit Basis(const std::size_t n) : n_(n) {}

  [[nodiscard]] std::size_t size() const { return rows_.size() / n_; }

  // The part of v orthogonal to all of them; twice, so that it is so to rounding.
  void make_orthogonal(const std::span<double> v) const {
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t k = 0; k < size(); ++k) {
        const View b = std::span(rows_).subspan(k * n_, n_);
        const double along = dot(b, v);
        for (std::size_t i = 0; i < n_; ++i) v[i] -= along * b[i];
      }
    }
  }

  // False if v depends on the directions found.
  bool extend(std::vector<double> v) {
    make_orthogonal(v);
    const double length = norm(v);
    if (!(length > 0.0)) return false;
    for (double& x : v) x /= length;
    rows_.insert(rows_.end(), v.begin(), v.end());
    return true;
  }

  // A unit vector orthogonal to all, from the coordinate axis that has most left.
  [[nodiscard]] std::vector<double> orthogonal() const {
    std::vector<double> best(n_);
    double longest = -1.0;
    for (std::size_t axis = 0; axis < n_; ++axis) {
      std::vector<double> v(n_);
      v[axis] = 1.0;
      make_orthogonal(v);
      if (const double length = norm(v); length > longest) {
        longest = length;
        best = std::move(v);
      }
    }
    for (double& x : best) x /= longest;
    return best;
  }

 private:
  std::size_t n_;
  std::vector<double> rows_;
};

std::vector<double> difference(const View a, const View b) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

// Adds points of the set along directions orthogonal to the corral's until there are n + 1.
StartSimplex extended(const ConvexSet& set, const Corral& corral) {
  const std::size_t n = set.dimension();
  const View base = corral.point(0);
  StartSimplex simplex{StartState::kFound, {base.begin(), base.end()}, std::vector<double>(n)};
  simplex.direction[0] = 1.0;
  Basis basis(n);
  const auto take = [&](const View point) {
    if (!basis.extend(difference(point, base))) return false;
    simplex.points.insert(simplex.points.end(), point.begin(), point.end());
    return true;
  };
  for (std::size_t k = 1; k < corral.size(); ++k) take(corral.point(k));
  std::vector<double> up(n);
  std::vector<double> down(n);
  while (basis.size() < n) {
    std::vector<double> u = basis.orthogonal();
    const double height = dot(u, base);
    const double above = support(set, u, up) - height;
    for (double& x : u) x = -x;
    const double below = support(set, u, down) + height;
    if (!(std::max(above, below) > 2.0 * rounding_along(set, u)) ||
        !take(above > below ? up : down)) {
      return {StartState::kFlat, {}, std::move(u)};
    }
    simplex.direction = u;
  }
  return simplex;
}

}  // namespace

double rounding_along(const ConvexSet& set, const View u) {
  return weighted_norm(u, set.error());
}

StartSimplex start_simplex(const ConvexSet& set) {
  const std::size_t n = set.dimension();
  const double floor = norm(set.error());
  std::vector<double> u(n);
  std::vector<double> s(n);
  u[0] = 1.0;
  support(set, u, s);
  Corral corral = single_point(s);
  for (std::size_t step = 0; step < kMostStartSteps; ++step) {
    const double distance = norm(corral.nearest);
    if (distance <= floor) break;
    for (std::size_t i = 0; i < n; ++i) u[i] = -corral.nearest[i] / distance;
    if (support(set, u, s) < -rounding_along(set, u)) return {StartState::kOutside, {}, u};
    if (!take_in(corral, s) || !(norm(corral.nearest) < distance)) break;
  }
  return extended(set, corral);
}

}  // namespace pdg
