#include "penetration_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "distance_bounds.hpp"
#include "facet_queue.hpp"
#include "pdg/native/tolerances.hpp"
#include "simplex_planes.hpp"
#include "simplicial_hull.hpp"
#include "start_simplex.hpp"

namespace pdg {
namespace {

using View = std::span<const double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> unit(const View u) {
  double square = 0.0;
  for (const double x : u) square += x * x;
  std::vector<double> result(u.begin(), u.end());
  for (double& x : result) x /= std::sqrt(square);
  return result;
}

// The best upper bound so far, with its direction.
struct Upper {
  double bound = kInfinity;
  std::vector<double> direction;
  std::vector<double> point;
};

// One computation; the names are those of [GFE] Algorithm 1.
template <std::size_t N>
class Growth {
 public:
  Growth(const ConvexSet& a, const ConvexSet& q, const StartSimplex& start,
         const SimplexPlanes& planes)
      : a_(a),
        q_(q),
        centre_(planes.centre),
        slack_weight_(product_rounding(a)),
        hull_(a.dimension(), start.points, planes.planes),
        s_(a.dimension()) {
    for (std::size_t i = 0; i < slack_weight_.size(); ++i) {
      const double product = slack_weight_[i];
      slack_weight_[i] += a.error()[i];
      if (product > 0.0) product_share_ = std::max(product_share_, product / slack_weight_[i]);
    }
    for (std::size_t id = 0; id < hull_.id_bound(); ++id) {
      const Id facet = static_cast<Id>(id);
      for (const Id vertex : hull_.vertices(facet)) {
        const double residual = std::abs(hull_.height(facet, hull_.point(vertex)));
        first_residual_ = std::max(first_residual_, residual);
      }
      enqueue(facet);
    }
  }

  PenetrationDistance run(const DistanceLimits& limits, const std::function<bool()>& interrupted,
                          const std::function<void(const DistanceStep&)>& listener) {
    double tightening = 0.0;
    for (;;) {
      const StopReason reason = grow(limits, tightening, interrupted, listener);
      if (outside_) return answer(OriginState::kOutside, reason, -kInfinity);
      const double lower = sound() ? std::min(certified_lower_bound(), upper_.bound) : 0.0;
      const OriginState state = lower > 0.0 ? OriginState::kInside : OriginState::kBoundary;
      const double excess = upper_.bound - lower - allowed_gap(limits);
      if (reason != StopReason::kConverged || !(excess > 0.0)) return answer(state, reason, lower);
      // The bracket is wide enough only without rounding: aim for a narrower one.
      tightening += 2.0 * excess;
      if (!(tightening < allowed_gap(limits))) {
        return answer(state, StopReason::kPrecision, lower);
      }
    }
  }

 private:
  using Id = std::int32_t;  // SimplicialHull<N>::Id, which Clang 14 takes only with a typename

  [[nodiscard]] double allowed_gap(const DistanceLimits& limits) const {
    const double relative = limits.relative_gap > 0.0 ? limits.relative_gap * upper_.bound : 0.0;
    return std::max(limits.absolute_gap, relative);
  }

  // Adds support points until the bracket in plain doubles is narrow enough ([GFE] Algorithm 1,
  // lines 5-9).
  StopReason grow(const DistanceLimits& limits, const double tightening,
                  const std::function<bool()>& interrupted,
                  const std::function<void(const DistanceStep&)>& listener) {
    for (;;) {
      const std::optional<QueuedFacet> top = queue_.least(hull_);
      if (!top || top->bound >= upper_.bound) return StopReason::kConverged;
      const View m = hull_.normal(top->facet);
      const double h_a = support(a_, m, s_);
      if (h_a < -rounding_along(a_, m) * kSumPadding) {
        outside_ = true;
        upper_ = {-kInfinity, {m.begin(), m.end()}, s_};
        return StopReason::kConverged;
      }
      lower_upper_bound(m, h_a);
      if (listener) listener({std::max(top->bound, 0.0), upper_.bound, hull_.facet_count()});
      if (upper_.bound - top->bound <= allowed_gap(limits) - tightening) {
        return StopReason::kConverged;
      }
      // A facet that the origin is on or beyond must move by more than rounding.
      const double seen = hull_.height(top->facet, s_);
      const double slack = top->bound > 0.0 ? 0.0 : weighted_norm(m, slack_weight_);
      if (!(seen > std::max(slack, kSeenHeight))) {
        if (q_.value(m) > rounding_along(q_, m)) return StopReason::kPrecision;
        // Q has no extent beyond this plane: it sets no bound ([GFE] Eq. 24), but within rounding
        // none can be proved either.
        queue_.drop();
        continue;
      }
      if (iterations_ >= limits.iterations) return StopReason::kIterations;
      if (hull_.facet_count() >= limits.facets) return StopReason::kFacets;
      if (interrupted()) return StopReason::kInterrupted;
      for (const Id facet : hull_.add(s_, top->facet)) enqueue(facet);
      ++iterations_;
    }
  }

  void lower_upper_bound(const View m, const double h_a) {
    const double bound = std::max(upper_bound(a_, q_, m, h_a, q_.value(m)), 0.0);
    if (bound < upper_.bound || upper_.direction.empty())
      upper_ = {bound, {m.begin(), m.end()}, s_};
  }

  // Facets that the origin is not strictly below come first, the farthest first of all. [GFE] Eq.
  // 24 gives those through the origin the bound 0, or infinity if h_Q(m) = 0; we remove the latter
  // too, for no bound can be proved with them.
  void enqueue(const Id facet) {
    const View m = hull_.normal(facet);
    const double delta = hull_.offset(facet);
    const double slack = weighted_norm(m, slack_weight_);
    worst_slack_ = std::max(worst_slack_, slack);
    double bound = 0.0;
    if (delta > slack) {
      bound = plain_bound(delta, q_.value(m));
    } else {
      bound = std::min(0.0, delta / weighted_norm(m, a_.magnitude()));
    }
    if (bound < upper_.bound) queue_.push({bound, facet, hull_.generation(facet)});
  }

  // The lower bound of distance_bounds.hpp, over all facets.
  [[nodiscard]] double certified_lower_bound() const {
    double least = kInfinity;
    for (std::size_t id = 0; id < hull_.id_bound(); ++id) {
      const Id facet = static_cast<Id>(id);
      if (!hull_.alive(facet)) continue;
      const View m = hull_.normal(facet);
      double delta = kInfinity;
      for (const Id vertex : hull_.vertices(facet)) {
        delta = std::min(delta, dot(m, hull_.point(vertex)));
      }
      least = std::min(least, facet_bound(q_, m, delta, weighted_norm(m, slack_weight_),
                                          q_.value(m), dot(m, centre_)));
    }
    return std::max(least, 0.0);
  }

  // Whether every facet there ever was had its vertices, wherever within rounding they are, farther
  // out than the centre by half the distance of its plane at least: then no step has taken the
  // surface across the centre.
  [[nodiscard]] bool sound() const {
    const double steps = static_cast<double>(iterations_ + 2);
    const double drift = steps * (kPlaneDriftUnits * product_share_ * worst_slack_ + kSeenHeight);
    return worst_slack_ + first_residual_ + drift < 0.5;
  }

  [[nodiscard]] PenetrationDistance answer(const OriginState state, const StopReason reason,
                                           const double lower) const {
    PenetrationDistance result;
    result.state = state;
    result.reason = reason;
    result.lower = lower;
    result.upper = upper_.bound;
    if (!upper_.direction.empty()) result.direction = unit(upper_.direction);
    result.point = upper_.point;
    result.iterations = iterations_;
    result.facets = hull_.facet_count();
    return result;
  }

  const ConvexSet& a_;
  const ConvexSet& q_;
  std::vector<double> centre_;
  // Per coordinate of m: what rounding may make of m.v, v a computed point of A in place of a point
  // of A; and how much of it, at most, is due to the product, not to the point.
  std::vector<double> slack_weight_;
  double product_share_ = 0.0;
  SimplicialHull<N> hull_;
  FacetQueue queue_;
  Upper upper_;
  std::vector<double> s_;
  std::size_t iterations_ = 0;
  double worst_slack_ = 0.0;
  double first_residual_ = 0.0;  // of the first simplex's planes at their vertices
  bool outside_ = false;
};

PenetrationDistance without_polytope(const OriginState state, const ConvexSet& a,
                                     const ConvexSet& q, const std::vector<double>& direction) {
  PenetrationDistance result;
  result.state = state;
  result.direction = direction;
  result.point.resize(direction.size());
  support(a, direction, result.point);
  if (state == OriginState::kOutside) {
    result.lower = result.upper = -kInfinity;
    return result;
  }
  result.upper = std::max(0.0, upper_bound_along(a, q, direction));
  return result;
}

using Grow = PenetrationDistance (*)(const ConvexSet&, const ConvexSet&, const StartSimplex&,
                                     const SimplexPlanes&, const DistanceLimits&,
                                     const std::function<bool()>&,
                                     const std::function<void(const DistanceStep&)>&);

template <std::size_t N>
PenetrationDistance grown(const ConvexSet& a, const ConvexSet& q, const StartSimplex& start,
                          const SimplexPlanes& planes, const DistanceLimits& limits,
                          const std::function<bool()>& interrupted,
                          const std::function<void(const DistanceStep&)>& listener) {
  return Growth<N>(a, q, start, planes).run(limits, interrupted, listener);
}

Grow for_dimension(const std::size_t n) {
  switch (n) {
    case 2:
      return grown<2>;
    case 3:
      return grown<3>;
    case 4:
      return grown<4>;
    case 5:
      return grown<5>;
    case 6:
      return grown<6>;
    case 7:
      return grown<7>;
    case 8:
      return grown<8>;
    default:
      return grown<0>;
  }
}

}  // namespace

double upper_bound_along(const ConvexSet& a, const ConvexSet& q, const View u) {
  return upper_bound(a, q, u, a.value(u), q.value(u));
}

PenetrationDistance penetration_distance(const ConvexSet& a, const ConvexSet& q,
                                         const DistanceLimits& limits,
                                         const std::function<bool()>& interrupted,
                                         const std::function<void(const DistanceStep&)>& listener) {
  const StartSimplex start = start_simplex(a);
  if (start.state == StartState::kOutside) {
    return without_polytope(OriginState::kOutside, a, q, start.direction);
  }
  if (start.state == StartState::kFlat) {
    return without_polytope(OriginState::kFlat, a, q, start.direction);
  }
  const std::optional<SimplexPlanes> planes = simplex_planes(a.dimension(), start.points);
  if (!planes) {
    PenetrationDistance unclear = without_polytope(OriginState::kBoundary, a, q, start.direction);
    unclear.reason = StopReason::kPrecision;
    return unclear;
  }
  return for_dimension(a.dimension())(a, q, start, *planes, limits, interrupted, listener);
}

}  // namespace pdg
