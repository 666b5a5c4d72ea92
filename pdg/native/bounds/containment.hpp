// The placement of a convex body inside a convex container that is nearest to a given configuration
// under DISP: a two-dimensional LP-type problem at a fixed angle, and a search over angles. In the
// plane this takes the place of [PDG] section 5's two levels of linear programmes with small turns:
// at each angle the containment and the least DISP are exact, not linearised.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "convex_separators.hpp"
#include "pdg/native/geometry/enclosing_circle.hpp"
#include "pdg/native/pieces/piece_set.hpp"
#include "pdg/native/slices/farthest_point.hpp"

namespace pdg {

struct NearestPoint {
  Vec2 point;
  double distance = 0.0;  // farthest.value(point)
};

// The point of {x : normal_j . x <= offset_j for all j} at which `farthest` is least, if that is
// below `bound`. Half-planes are taken in their order (Seidel); each that the point so far violates
// moves it to the least point of the stretch that the ones before leave of its line. Plain doubles:
// half-planes may be violated by a few roundings of the coordinates.
std::optional<NearestPoint> nearest_in_container(const FarthestPoint& farthest,
                                                 std::span<const HalfPlane> sides, double bound);

// The hull of a body at a configuration, turning about the centre of its smallest circle.
struct TurningBody {
  Pose pose;
  Circle circle;              // smallest round the hull, in the body's frame
  Vec2 centre;                // its centre, placed
  std::vector<Vec2> spokes;   // hull vertices less the circle's centre, in the body's frame
  std::vector<Vec2> at_pose;  // the same turned to the pose
};

void make_turning_body(const PieceSet& body, const Pose& pose, TurningBody& result);

// DISP to any placement in the container is at least that: the body point deepest beyond a side
// must come inside.
double least_way_in(const TurningBody& body, const ConvexSeparator& container);

struct Placement {
  Pose pose;
  double displacement = std::numeric_limits<double>::infinity();
};

struct ContainmentScratch {
  struct Interval {
    double lower = 0.0;   // no placement at these angles has a smaller DISP
    double middle = 0.0;  // turn from the configuration asked about, radians
    double half = 0.0;
  };
  std::vector<Interval> heap;
  FarthestPoint farthest;
  std::vector<HalfPlane> sides;
};

// A placement inside the container, shrunk by `margin`, with a DISP below `bound` and within
// kContainmentTolerance of the least there is, if there is one below `bound` by as much. Branch and
// bound over the angle, then a local search. Plain doubles. Adds to `placements` the number of
// angles at which a nearest point was looked for.
std::optional<Placement> nearest_placement(const TurningBody& body,
                                           const ConvexSeparator& container, double margin,
                                           double bound, ContainmentScratch& scratch,
                                           int& placements);

}  // namespace pdg
