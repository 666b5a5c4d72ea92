// The star test: a MIXED cell or face whose free part is star-shaped about a guard o is as good as
// free, because every free configuration of the closed set sees the guard along a straight segment
// (design: "Star-shaped cells"; [STAR]).
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

class StarTest {
 public:
  explicit StarTest(const ObstacleTree& tree) : tree_(tree) {}

  // The translation of a guard at the motion's central rotation, if the test finds one: certified
  // free, and seen by every free configuration of the motion. `list` is the motion's own undecided
  // list.
  std::optional<Vec2> find_guard(const pdg::Motion& motion, PosedRobot& posed,
                                 const ConstraintView& list);

 private:
  // {t : normal . t > offset}
  struct HalfPlane {
    Vec2 normal;
    double offset;
  };

  bool collect(const pdg::Motion& motion, PosedRobot& posed, const ConstraintView& list);
  void obstacle_edge(const pdg::Motion& m, const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                     const pdg::Constraint& c, double error);
  void robot_edge(const pdg::Motion& m, const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                  const pdg::Constraint& c, double error);
  bool add(HalfPlane plane);
  void start_polygon(const pdg::Motion& motion);

  const ObstacleTree& tree_;
  std::vector<HalfPlane> planes_;
  std::vector<Vec2> polygon_;  // where the guard may be, clipped as the planes come in
  std::vector<Vec2> clipped_;
  std::vector<double> heights_;  // of the polygon's vertices above a plane
};

// The configuration (t, central rotation of `posed`) is free: every pair of `list` has an axis that
// separates it by more than `margin` and the rounding error. Complete for configurations inside the
// list's cell.
bool is_free(const ObstacleTree& tree, PosedRobot& posed, Vec2 t, double reach,
             const ConstraintView& list, double margin = 0.0);

}  // namespace planner
