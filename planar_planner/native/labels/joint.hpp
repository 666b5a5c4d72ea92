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
#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/posed_robot.hpp"
#include "weights.hpp"

namespace planner {

class JointTest {
 public:
  explicit JointTest(const ObstacleTree& tree) : tree_(tree) {}

  // True: proven, in exact arithmetic, that no configuration of the motion is free. `list` is the
  // motion's own undecided list.
  bool obstructs(const pdg::Motion& motion, PosedRobot& posed, const ConstraintView& list) {
    look_at(motion, posed, list);
    return obstructs(motion);
  }
  // The same of parts of the motion that was looked at last, with the same centre.
  bool obstructs(const pdg::Motion& part);
  void look_at(const pdg::Motion& motion, PosedRobot& posed, const ConstraintView& list);

  // What is behind the last `true`, which was about this list.
  [[nodiscard]] JointProof proof(const ConstraintView& list) const;

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
  // A pair of the list, where its constraints begin, and how many they are.
  struct Place {
    std::size_t pair;
    std::size_t first;
    std::size_t choices = 0;
  };
  struct TermRange {
    std::size_t begin;
    std::size_t end;
  };

  void add_terms(const pdg::Motion& motion, PosedRobot& posed, const PairHeader& pair,
                 const pdg::Constraint& constraint);
  void add_term(const pdg::Motion& motion, const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                const JointTerm& source, double error);
  void choose_branches(const ConstraintView& list);
  void weigh(const pdg::Motion& motion, TermRange range);
  bool refute(const pdg::Motion& motion);
  bool proves(const pdg::Motion& motion, const WeightProgram::Weights& weights);
  void note_sum(const WeightProgram::Weights& weights);

  const ObstacleTree& tree_;
  // Terms of the pairs with one active axis, then those of the choices.
  std::vector<Term> terms_;
  std::size_t fixed_ = 0;
  std::vector<Place> several_;     // the pairs with a choice
  std::vector<TermRange> ranges_;  // of their axes, one after another
  std::size_t cases_ = 0;
  std::vector<std::size_t> weighed_;  // terms in the programme
  WeightProgram program_;             // the terms, without second-order terms of turning edges
  WeightProgram bent_;                // with all of them
  std::vector<JointTerm> noted_;      // the weighted terms of all sums that prove
  std::vector<std::size_t> ends_;     // of each sum
};

}  // namespace planner
