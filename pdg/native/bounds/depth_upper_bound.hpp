// Upper bounds of the generalized penetration depth PD^g, each with a free configuration that shows
// it ([PDG] section 6.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "containment.hpp"
#include "convex_separators.hpp"
#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

enum class UpperBoundSource : std::uint8_t {
  kFree,       // the configuration asked about is free itself
  kHulls,      // a translation that takes the convex hulls apart
  kSeparator,  // A's hull inside a convex container
};

// A configuration at which the interiors are disjoint: by interiors_are_disjoint, exactly for the
// doubles that A's vertices are placed at.
struct FreePlacement {
  Pose pose;
  UpperBoundSource source = UpperBoundSource::kFree;
  int separator = -1;  // its index, if the source is one
  bool drawn_back = false;
};

struct DepthUpperBound {
  double displacement = 0.0;  // PD^g under DISP is at most DISP(q, displaced.pose)
  FreePlacement displaced;
  double distance = 0.0;  // PD^g under D_g is at most this bound of D_g(q, distanced.pose)
  FreePlacement distanced;
  int placements = 0;  // angles at which a placement in a container was computed
};

struct UpperBoundScratch {
  DepthScratch depth;
  PlacedBody hull;  // A's
  TurningBody body;
  ContainmentScratch containment;
  std::vector<std::pair<double, std::size_t>> order;  // least_way_in and index of separators
};

// UB2: PD^t of the convex hulls ([PDG] section 6.2.2), 0 where their interiors are disjoint. The
// translation goes beyond touching by four times the rounding error of a separating-axis function:
// that error at either configuration, and as much again to confirm.
DepthUpperBound hull_upper_bound(const PieceSet& a, const PieceSet& b, const Pose& pose,
                                 UpperBoundScratch& scratch);

// UB1: 0 where the interiors are disjoint, else the least of UB2 and of DISP to placements of A's
// hull in convex containers of B's complement ([PDG] section 6.2.3). Containers whose deepest
// half-plane already asks for more than the bound so far are culled (section 6.2.5).
DepthUpperBound separator_upper_bound(const PieceSet& a, const PieceSet& b,
                                      const std::vector<ConvexSeparator>& separators,
                                      const Pose& pose, UpperBoundScratch& scratch);

// UB1, whose placements free the convex hull of one body at least, and then more than that: along
// the way from the configuration asked about to those of UB1 and of UB2, the first free one of an
// even sample, and from there back by bisection until the bodies themselves are about to touch.
// Never above UB1.
DepthUpperBound drawn_back_upper_bound(const PieceSet& a, const PieceSet& b,
                                       const std::vector<ConvexSeparator>& separators,
                                       const Pose& pose, UpperBoundScratch& scratch);

}  // namespace pdg
