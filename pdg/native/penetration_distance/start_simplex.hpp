// A full-dimensional simplex of points of a convex set that holds the origin ([GFE] section IV.D).
#pragma once

#include <cstdint>
#include <vector>

#include "pdg/native/convex_sets/convex_set.hpp"

namespace pdg {

enum class StartState : std::uint8_t {
  kFound,    // `points` is the simplex
  kOutside,  // proof: h(direction) < 0, rounding included
  kFlat,     // h(direction) + h(-direction) = 0 to within rounding
};

struct StartSimplex {
  StartState state = StartState::kFound;
  // n + 1 rows, affinely independent. The origin is in their hull, on its boundary perhaps, to
  // within rounding; it may be out of it if rounding decides whether it is in the set at all.
  std::vector<double> points;
  // Unit; outside and flat: the direction concerned; found: any, a thin one if points had to be
  // added.
  std::vector<double> direction;
};

// GJK with the nearest points found by Wolfe's method: the set's support points in the direction of
// the origin are taken in until their hull holds it; a simplex of fewer than n + 1 points is then
// extended along directions orthogonal to it. The set should be about as wide in every direction.
StartSimplex start_simplex(const ConvexSet& set);

// The bound of error() for a direction: sum |u_i| error_i.
double rounding_along(const ConvexSet& set, std::span<const double> u);

}  // namespace pdg
