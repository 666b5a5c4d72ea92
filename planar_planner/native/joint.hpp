// Joint obstruction: a cell can lie in C-obstacle although no single pair covers it. Where a pair
// has one active separating axis left, a free configuration satisfies s_k(q) >= 0 for every vertex
// of it. If weights lambda_k >= 0 exist with
//     max over the cell of  sum_k lambda_k s_k(q)  <  0,
// no configuration of the cell is free (Farkas' lemma). Obstacle edges contribute
// n . t + v cos(delta) + w sin(delta) - d, robot edges the same with n = -M up to a second-order
// term, so the sum is linear in t plus one sinusoid, whose range is closed-form. First-order terms
// that cancel between pairs do cancel, which is what makes the number of cells near a critical
// clearance e grow with log(1/e) instead of 1/sqrt(e).
#pragma once

#include <array>
#include <vector>

#include "constraints.hpp"
#include "full_claim.hpp"
#include "obstacle_tree.hpp"
#include "pdg/native/motion.hpp"
#include "robot.hpp"

namespace planner {

class JointTest {
 public:
  JointTest(const Robot& robot, const ObstacleTree& tree) : robot_(robot), tree_(tree) {}

  // True: proven, in exact arithmetic, that no configuration of the motion is free. `list` is the
  // motion's own undecided list.
  bool obstructs(const pdg::Motion& motion, const pdg::PosedRobot& posed,
                 const ConstraintView& list);

  // The weighted terms behind the last `true`.
  [[nodiscard]] JointProof proof() const;

 private:
  // s_k = value + normal . e + v cos(delta) + w sin(delta), up to +- bend, over the cell's
  // deviations e of the translation and delta of the angle.
  struct Term {
    Vec2 normal;
    double v, w;
    double value;
    double bend;
    double error;
    JointTerm source;
  };
  static constexpr int kRows = 4;  // x, y, delta, and the weights' sum
  using Column = std::array<double, kRows>;

  void collect(const pdg::Motion& motion, const pdg::PosedRobot& posed, const ConstraintView& list);
  void add_term(const pdg::Motion& motion, const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                const JointTerm& source, double error);
  bool find_weights(const pdg::Motion& motion);
  [[nodiscard]] bool proves(const pdg::Motion& motion) const;

  const Robot& robot_;
  const ObstacleTree& tree_;
  std::vector<Term> terms_;
  std::vector<Column> columns_;
  std::vector<double> costs_;
  std::vector<double> weights_;
};

}  // namespace planner
