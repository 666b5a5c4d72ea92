// The generalized penetration distance d_Q(A) = max {l >= 0 : l Q in A} = min over |u| = 1 of
// h_A(u) / h_Q(u) ([GFE] Eq. 16 and Proposition 1), by growing a polytope in A ([GFE] Algorithm 1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "pdg/native/convex_sets/convex_set.hpp"

namespace pdg {

enum class OriginState : std::uint8_t {
  kInside,    // the origin is an interior point of A: lower > 0 ...
  kBoundary,  // ... or so near A's boundary that rounding decides on which side: lower = 0
  kOutside,   // h_A(direction) < 0: no multiple of Q fits, lower = upper = -infinity
  kFlat,  // A has no interior: h_A(direction) = h_A(-direction) = 0 to within rounding, lower = 0
};

enum class StopReason : std::uint8_t {
  kConverged,   // upper - lower <= eps, or the state is outside or flat
  kIterations,  // limits
  kFacets,
  kInterrupted,
  kPrecision,  // rounding does not allow a narrower bracket
};

struct DistanceLimits {
  double absolute_gap = 1e-4;  // stop once upper - lower <= max(absolute, relative * upper)
  double relative_gap = 0.0;
  std::size_t iterations = 100000;
  std::size_t facets = 10000000;
};

// One iteration's bracket, for plots of convergence.
struct DistanceStep {
  double lower = 0.0;
  double upper = 0.0;
  std::size_t facets = 0;
};

// The bounds hold for the exact sets that the input doubles describe, rounding included, given what
// the sets promise (ConvexSet).
struct PenetrationDistance {
  OriginState state = OriginState::kInside;
  StopReason reason = StopReason::kConverged;
  double lower = 0.0;
  double upper = 0.0;
  std::vector<double> direction;  // unit u with h_A(u) / h_Q(u) <= upper
  std::vector<double> point;      // s_A(u)
  std::size_t iterations = 0;     // points added to the first simplex
  std::size_t facets = 0;         // of the last polytope
};

// A and Q of one dimension, Q holding the origin. For the sake of rounding A should be about as
// wide in every direction; linear maps of both sets do not change d. `interrupted` is asked once an
// iteration; `listener`, if any, is told the bracket of each (the lower bound in plain doubles).
PenetrationDistance penetration_distance(
    const ConvexSet& a, const ConvexSet& q, const DistanceLimits& limits,
    const std::function<bool()>& interrupted,
    const std::function<void(const DistanceStep&)>& listener = {});

// h_A(u) / h_Q(u) rounded up, a bound of d_Q(A) for any u; infinite if h_Q(u) may be 0.
double upper_bound_along(const ConvexSet& a, const ConvexSet& q, std::span<const double> u);

}  // namespace pdg
