// Joint obstruction: a cell can lie in C-obstacle although no single pair covers it. Where a pair
// has one active separating axis left, a free configuration satisfies s_k(q) >= 0 for every vertex
// of it. If weights lambda_k >= 0 exist with
//     max over the cell of  sum_k lambda_k s_k(q)  <  0,
// no configuration of the cell is free (Farkas' lemma). Obstacle edges contribute
// n . t + v cos(delta) + w sin(delta) - d, robot edges the same with n = -M up to a second-order
// term, so the sum is linear in t plus one sinusoid, whose range is closed-form. First-order terms
// that cancel between pairs do cancel, and so do second-order ones, which is what makes the number
// of cells near a critical clearance e grow with log(1/e) instead of 1/sqrt(e).
// A pair with several active axes left says "s_1 >= 0 or s_2 >= 0 or ...": for a few such pairs all
// choices of one axis each are tried, and each must be refuted.
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

  // What is behind the last `true`.
  [[nodiscard]] const JointProof& proof() const { return proof_; }

 private:
  // s_k = value + normal . e + v cos(delta) + w sin(delta), up to +- bend, over the cell's
  // deviations e of the translation and delta of the angle.
  struct Term {
    Vec2 normal;
    Vec2 turning;  // of a robot edge, which turns: its normal at the centre; otherwise zero
    double v, w;
    double value;
    double error;
    JointTerm source;
  };
  static constexpr int kRows = 4;  // x, y, delta, and the weights' sum
  using Column = std::array<double, kRows>;

  // A pair of the list, and where its constraints begin.
  struct Place {
    std::size_t pair;
    std::size_t first;
  };

  void collect(const pdg::Motion& motion, const pdg::PosedRobot& posed, const ConstraintView& list);
  void add_terms(const pdg::Motion& motion, const pdg::PosedRobot& posed, const PairHeader& pair,
                 const pdg::Constraint& constraint);
  void add_term(const pdg::Motion& motion, const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                const JointTerm& source, double error);
  bool refute_cases(const pdg::Motion& motion, const pdg::PosedRobot& posed,
                    const ConstraintView& list);
  bool refute(const pdg::Motion& motion);
  bool find_weights(const pdg::Motion& motion, bool with_bends);
  void note_sum();
  [[nodiscard]] bool proves(const pdg::Motion& motion) const;

  const Robot& robot_;
  const ObstacleTree& tree_;
  std::vector<Term> terms_;
  std::vector<Place> several_;  // pairs with several active axes
  JointProof proof_;
  std::vector<Column> columns_;
  std::vector<double> costs_;
  std::vector<double> weights_;
};

}  // namespace planner
