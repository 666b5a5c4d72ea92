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
#include <optional>
#include <vector>

#include "constraints.hpp"
#include "full_claim.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/posed_robot.hpp"
#include "tuning.hpp"
#include "weights.hpp"

namespace planner {

// The conditions that the undecided pairs of a motion put on a free configuration, written about
// the motion's centre. They are the same for every part of the motion that has the same centre.
struct JointTerms {
  // s_k = value + normal . e + v cos(delta) + w sin(delta), up to +- bend, over the motion's
  // deviations e of the translation and delta of the angle.
  struct Term {
    Vec2 normal;
    Vec2 turning;  // of a robot edge, which turns: its normal at the centre; otherwise zero
    double v, w;
    double value;
    double error;
    JointTerm source;
  };
  // A pair of the list with several axes, of which a free configuration needs one.
  struct Choice {
    std::size_t pair;
    std::size_t first;  // its first constraint in the list
    std::size_t axes = 0;
  };
  struct Range {
    std::size_t begin;
    std::size_t end;
  };

  std::vector<Term> terms;  // of the pairs with one axis, then of the axes to choose from
  std::size_t fixed = 0;    // how many belong to pairs with one axis
  std::vector<Choice> choices;
  std::vector<Range> ranges;  // the terms of each axis of each choice, one after another
  std::size_t cases = 1;      // ways to choose one axis for each
};

// `list` is the motion's own undecided list.
void gather_terms(const ObstacleTree& tree, const pdg::Motion& motion, PosedRobot& posed,
                  const ConstraintView& list, JointTerms& out);

// Weighted sums of terms, each negative all over a motion: one, or one for every way to choose.
struct Refutation {
  std::array<WeightProgram::Weights, kMostCases> sums{};  // functions are indices of terms
  std::size_t count = 0;
};

// Memory that refute() works in; nothing in it outlives a call.
struct JointScratch {
  std::vector<std::size_t> weighed;  // terms in the programme
  WeightProgram program;             // the terms, without second-order terms of turning edges
  WeightProgram bent;                // with all of them
};

// Why no configuration of the motion is free, in exact arithmetic, if that could be proven. The
// terms may be those of a larger motion with the same centre.
std::optional<Refutation> refute(const JointTerms& terms, const pdg::Motion& motion,
                                 JointScratch& scratch);

// The same as evidence; `list` is what the terms were gathered from.
JointProof proof_of(const Refutation& refutation, const JointTerms& terms,
                    const ConstraintView& list);

}  // namespace planner
