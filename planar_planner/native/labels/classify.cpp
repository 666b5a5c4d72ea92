#include "classify.hpp"

#include <utility>

namespace planner {

namespace {

double motion_radius(const pdg::Motion& m, const double turning_radius) {
  return pdg::norm({m.g1.x, m.g2.y}) + turning_radius * m.half_angle;
}

// The two further questions, about a motion that `list` leaves undecided, or about a part of it
// with the same centre. `scratch.terms` are those of the list.
struct Asker {
  const Labeller& labeller;
  PosedRobot& posed;
  ConstraintView list;
  bool joint;
  Scratch& scratch;

  [[nodiscard]] std::optional<Refutation> refutation(const pdg::Motion& m) const {
    return joint ? refute(scratch.terms, m, scratch.joint) : std::nullopt;
  }
  [[nodiscard]] std::optional<Vec2> guard(const pdg::Motion& m) const {
    if (!labeller.ablation().star) return std::nullopt;
    return find_guard(labeller.tree(), m, posed, list, scratch.star);
  }
};

void ask_joint(const Asker& asker, const pdg::Motion& motion, Classification& out) {
  if (!asker.joint) return;
  gather_terms(asker.labeller.tree(), motion, asker.posed, asker.list, asker.scratch.terms);
  const auto refutation = asker.refutation(motion);
  if (!refutation) return;
  out.label = Label::kFull;
  out.joint = proof_of(*refutation, asker.scratch.terms, asker.list);
}

void ask_star(const Asker& asker, const pdg::Motion& motion, Classification& out) {
  const auto guard = asker.guard(motion);
  if (!guard) return;
  out.label = Label::kStar;
  out.guard = *guard;
}

// A part of no extent settles nothing: without it the motion is the same, and undecided.
std::array<bool, 3> settling_parts(const Asker& asker, const pdg::Motion& m) {
  const std::array<double, 3> extents{m.g1_length, m.g2_length, m.half_angle};
  std::array<bool, 3> out{};
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (extents[k] == 0.0) continue;
    const pdg::Motion flat = flattened(m, static_cast<pdg::MotionPart>(k));
    out[k] = asker.refutation(flat) || asker.guard(flat);
  }
  return out;
}

}  // namespace

Classification classify(Labeller& labeller, const pdg::Motion& motion, PosedRobot& posed,
                        const ConstraintView& parent, const Questions& questions,
                        Scratch& scratch) {
  LabelResult by_pairs =
      labeller.label(motion, posed, parent, std::exchange(scratch.room, ConstraintList{}));
  Classification out;
  out.label = by_pairs.label;
  out.witness = by_pairs.witness;
  out.undecided = std::move(by_pairs.undecided);
  out.separation = by_pairs.separation;
  out.sway = by_pairs.sway;
  out.turning_radius = by_pairs.turning_radius;
  out.motion_radius = motion_radius(motion, by_pairs.turning_radius);
  if (out.label != Label::kMixed) return out;
  const bool joint = labeller.ablation().joint &&
                     (questions.joint_if_centre_looks_free || by_pairs.separation < 0.0);
  const Asker asker{labeller, posed, view(out.undecided), joint, scratch};
  (questions.star_first ? ask_star : ask_joint)(asker, motion, out);
  if (out.label == Label::kMixed) (questions.star_first ? ask_joint : ask_star)(asker, motion, out);
  const bool small = out.motion_radius / labeller.robot().reach < questions.settle_below;
  if (out.label == Label::kMixed && small) out.settles = settling_parts(asker, motion);
  return out;
}

}  // namespace planner
