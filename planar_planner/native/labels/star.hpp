// The star test: a MIXED cell or face whose free part is star-shaped about a guard o is as good as
// free, because every free configuration of the closed set sees the guard along a straight segment
// (docs/method.md, "Star-shaped cells"; [STAR]).
//
// It is enough that (q - o) . grad s(q) < 0 wherever an active function s vanishes in the set,
// because unions and intersections of "once inside, inside for good" sets keep that property.
// With theta_o = theta_c, K = cos h + h sin h, S = sin h - h cos h:
//   obstacle edge, vertex a:  n . t_o > d - min(v, v K) + |w| S
//   robot edge, vertex b:     M . (b - t_o) > max(c, c / K) + h D + |w_o| S
// where D bounds |M'(theta) . (t - t_o)|, M' = M turned by 90 degrees. All are half-planes in t_o.
#pragma once

#include <optional>
#include <vector>

#include "constraints.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/posed_robot.hpp"

namespace planner {

// {t : normal . t > offset}
struct HalfPlane {
  Vec2 normal;
  double offset;
};

// Memory that find_guard() works in; nothing in it outlives a call.
struct StarScratch {
  std::vector<HalfPlane> planes;
  std::vector<Vec2> polygon;  // where the guard may be, clipped as the planes come in
  std::vector<Vec2> clipped;
  std::vector<double> heights;  // of the polygon's vertices above a plane
};

// The translation of a guard at the motion's central rotation, if one is found: certified free, and
// seen by every free configuration of the motion. `list` is the undecided list of the motion, or of
// a larger one with the same centre.
std::optional<Vec2> find_guard(const ObstacleTree& tree, const pdg::Motion& motion,
                               PosedRobot& posed, const ConstraintView& list, StarScratch& scratch);

// The configuration (t, central rotation of `posed`) is free: every pair of `list` has an axis that
// separates it by more than `margin` and the rounding error. Complete for configurations inside the
// list's cell.
bool is_free(const ObstacleTree& tree, PosedRobot& posed, Vec2 t, double reach,
             const ConstraintView& list, double margin = 0.0);

}  // namespace planner
