// One pair over cells and faces: FREE and FULL, fresh and with lists handed down to deep levels.
#include "families.hpp"
#include "generate.hpp"
#include "pdg/native/tolerances.hpp"
#include "posed.hpp"
#include "truth/exact.hpp"

namespace rounding {

namespace {

using pdg::Constraint;

struct Judged {
  pdg::PairLabel label = pdg::PairLabel::kUndecided;
  planner::Extent extent;
  std::vector<Constraint> active;  // what it was judged from
};

class Chain {
 public:
  Chain(Random& random, const PairCase& c)
      : random_(random),
        case_(c),
        a_(pdg::make_piece(c.a, {{}, c.frame.exponent})),
        b_(pdg::make_piece(c.b, c.frame)) {
    pdg::all_constraints(a_, b_, judged_.active);
  }

  // Halves towards the target until the pair is decided, or for a random number of steps.
  const Judged& descend(const bool deep, const bool face) {
    std::array<int, 3> levels{random_.pick(0, 3), random_.pick(0, 3), random_.pick(2, 4)};
    const int steps = deep ? random_.pick(0, 140) : random_.pick(0, 24);
    // A face lies in one to three planes through the target, which is in its closed cell.
    const int planes = face ? random_.pick(1, 7) : 0;
    std::vector<Constraint> remaining;
    for (int step = 0;; ++step) {
      const planner::CellBox box = cell_at(case_.target, levels);
      judged_.extent = planner::extent_of(box);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((planes >> axis & 1) == 0) continue;
        judged_.extent.low[axis] = case_.target[axis];
        judged_.extent.size[axis] = 0;
      }
      remaining.clear();
      judged_.label = judge(remaining);
      if (step >= steps || judged_.label != pdg::PairLabel::kUndecided) return judged_;
      judged_.active = remaining;
      const auto axis = static_cast<std::size_t>(random_.pick(0, 2));
      if (levels[axis] < planner::kMaxLevel) ++levels[axis];
    }
  }

  // The range of one function that the pair was last judged from.
  void compare_range(Tally& tally, const exact::Piece& a, const exact::Piece& b,
                     const exact::Box& box) {
    const pdg::Motion m = planner::motion_of(case_.space, judged_.extent);
    const Posed posed(a_, planner::rotation_of(case_.space, judged_.extent));
    const double error = pdg::separation_error(a_, b_, m);
    // Against the bound as it stands, also where the margins have been taken out.
    const double bound = kSeparationUnits * pdg::kUnitRoundoff * (a_.reach + b_.reach + m.reach);
    const auto any = random_.pick(0, static_cast<int>(judged_.active.size()) - 1);
    Constraint c = judged_.active[static_cast<std::size_t>(any)];
    const pdg::Range range = pdg::constraint_range(posed.view(), b_, m, error, c);
    const exact::Axis axis{c.owner, c.edge};
    tally.not_above(range.lo, exact::least_value(a, b, axis, box), bound);
    tally.not_below(range.hi, exact::largest_value(a, b, axis, box), bound);
  }

 private:
  pdg::PairLabel judge(std::vector<Constraint>& remaining) {
    const pdg::Motion m = planner::motion_of(case_.space, judged_.extent);
    const Posed posed(a_, planner::rotation_of(case_.space, judged_.extent));
    std::uint64_t evaluations = 0;
    return pdg::judge_pair(posed.view(), b_, m, judged_.active, remaining, evaluations).label;
  }

  Random& random_;
  const PairCase& case_;
  pdg::ConvexPiece a_, b_;
  Judged judged_;
};

}  // namespace

std::vector<Tally> pairs(const Request& request) {
  Random random(request.seed);
  Tally free{.family = "pair FREE"};
  Tally full{.family = "pair FULL"};
  Tally face{.family = "face"};
  while (free.inputs < request.inputs || face.inputs < request.inputs) {
    const bool is_face = random.one_in(2);
    const PairCase c = pair_case(random, request.adversarial);
    Chain chain(random, c);
    const Judged& judged = chain.descend(request.adversarial, is_face);
    const exact::Piece a = exact::framed(exact::robot_frame(c.frame), c.a);
    const exact::Piece b = exact::framed(c.frame, c.b);
    const exact::Box box = exact::box_of(c.space, judged.extent);
    for (Tally* const tally : is_face ? std::vector{&face} : std::vector{&free, &full})
      ++tally->inputs;
    if (judged.label == pdg::PairLabel::kApart)
      (is_face ? face : free).claim(exact::apart(a, b, box));
    else if (judged.label == pdg::PairLabel::kOverlap)
      (is_face ? face : full).claim(exact::overlap(a, b, box));
    chain.compare_range(is_face ? face : full, a, b, box);
  }
  free.tightness = full.tightness;  // the same ranges
  free.values = full.values;
  return {free, full, face};
}

}  // namespace rounding
