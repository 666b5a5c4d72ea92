// Translational penetration depth PD^t of two convex polygons ([PDG] Eq. 1), and its negative
// counterpart, the distance of disjoint ones.
#pragma once

#include <cstdint>
#include <optional>

#include "pdg/native/geometry/polygon.hpp"
#include "placed_outline.hpp"

namespace pdg {

enum class PairState : std::uint8_t {
  kApart,     // no common point
  kTouching,  // common points, but disjoint interiors: PD^t = 0
  kOverlap,   // common interior points: PD^t > 0
};

// For the polygons as given in doubles: `state` is exact; depth, or distance, and direction have a
// relative error of kRelativeDepthErrorUnits u, however small they are; the points are rounded to
// the coordinates' doubles.
struct TranslationalDepth {
  PairState state = PairState::kApart;
  double depth = 0.0;  // overlap: PD^t > 0; touching: 0; apart: -distance
  Vec2 direction;      // unit: moving A by depth * direction makes the two touch
  Vec2 on_a;           // the point of A that then meets ...
  Vec2 on_b;           // ... this point of B: on_b = on_a + depth * direction
};

// Both strictly convex (or what place_outline leaves), counter-clockwise, in the same frame. Throws
// std::invalid_argument for a coordinate outside the range of predicates.hpp.
TranslationalDepth translational_depth(const ConvexPolygon& a, const ConvexPolygon& b);
TranslationalDepth translational_depth(const PlacedOutline& a, const PlacedOutline& b);

// The hull of a's vertices as placed, against b; `moved` is working memory.
TranslationalDepth translational_depth(const ConvexPolygon& a, const Pose& pose,
                                       const PlacedOutline& b, PlacedOutline& moved);

// The same for polygons that overlap by more than `depth` (in the doubles of translational_depth);
// else nothing, which is found out sooner. With the same exception.
std::optional<TranslationalDepth> overlap_deeper_than(const ConvexPolygon& a,
                                                      const ConvexPolygon& b, double depth);

// Whether the interiors meet; exact, with the same exception.
bool overlap_exactly(const ConvexPolygon& a, const ConvexPolygon& b);

// The state alone; exact.
PairState pair_state(const ConvexPolygon& a, const ConvexPolygon& b);

}  // namespace pdg
