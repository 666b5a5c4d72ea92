// Configurations pushed to where their clearance is largest locally: onto the ridge of the
// clearance function, along which a narrow gate can be passed. In plain doubles: a hint; only
// the certificates of the segments in between prove anything.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "max_min.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"
#include "planar_planner/native/labels/constraints.hpp"
#include "planar_planner/native/statistics.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/posed_robot.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// One separating-axis function of one pair of pieces.
struct PairAxis {
  std::uint32_t obstacle;
  std::uint16_t robot;
  std::uint16_t edge;
  pdg::EdgeOwner owner;

  [[nodiscard]] bool same_pair(const PairAxis& other) const {
    return obstacle == other.obstacle && robot == other.robot;
  }
};

struct Height {
  ScaledConfiguration q;
  double clearance = 0.0;  // least over pairs, planner units; negative: depth
};

class RidgeClimb {
 public:
  RidgeClimb(const ScaledProblem& problem, const ObstacleTree& tree, Statistics& statistics)
      : problem_(problem), tree_(tree), statistics_(statistics), posed_(problem.robot) {}

  // Adds the axes that a cell leaves undecided: all axes of pairs that are still closed, and none
  // of nodes.
  void add_axes(const ConstraintView& list, std::vector<PairAxis>& axes) const;
  // Sorts axes by pairs and keeps each once, as the functions below require.
  static void sort_axes(std::vector<PairAxis>& axes);

  // Adds for every pair the axis that separates it the most; returns the least separation.
  double add_best(const ScaledConfiguration& q, std::span<const PairAxis> axes,
                  std::vector<PairAxis>& best);
  // Adds for every pair all axes that separate it about as much as the best.
  void add_good(const ScaledConfiguration& q, std::span<const PairAxis> axes,
                std::vector<PairAxis>& good);

  // Steps up the clearance, none longer than `radius` (planner units, a turn counting as its
  // longest way), until it is a fair part of the radius or cannot grow; each pair by the axis that
  // is best where the step begins.
  Height climb(const ScaledConfiguration& from, double radius, std::span<const PairAxis> axes);
  // The same with all of these axes at once: to where every one of them separates, if there is such
  // a place nearby.
  Height climb_all(const ScaledConfiguration& from, double radius, std::span<const PairAxis> axes);

 private:
  template <class Linearise>
  Height climb_by(ScaledConfiguration at, double radius, const Linearise& linearise);
  template <class Visit>
  void each_vertex(const PairAxis& axis, Vec2 t, const Visit& visit);
  double value(const PairAxis& axis, Vec2 t);
  double add_terms(const PairAxis& axis, Vec2 t);
  [[nodiscard]] ScaledConfiguration moved(const ScaledConfiguration& from, const Step3& d) const;

  const ScaledProblem& problem_;
  const ObstacleTree& tree_;
  Statistics& statistics_;
  PosedRobot posed_;
  std::vector<PairAxis> best_;
  std::vector<double> values_;
  std::vector<LinearTerm> terms_, terms_here_;  // of the step tried, and where the climb has got to
};

}  // namespace planner
