#include "face.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tuning.hpp"

namespace planner {

namespace {

std::uint64_t middle(const std::uint64_t low, const std::uint64_t size) {
  return low + size / 2;
}

Axis widest_axis(const pdg::Motion& m, const double radius, const Extent& face) {
  const std::array<double, 3> width{m.g1.x, m.g2.y, radius * m.half_angle};
  Axis widest = kNoAxis;
  for (Axis k = 0; k < kNoAxis; ++k)
    if (face.size[k] > 1 && (widest == kNoAxis || width[k] > width[widest])) widest = k;
  return widest;
}

}  // namespace

Link FaceTest::test(const CellId a, const CellId b) {
  const std::uint64_t key = link_key(a, b);
  if (const auto known = open_.find(key); known != open_.end())
    return {LinkState::kOpen, known->second};
  const Link link = test_face(a, b);
  if (link.state == LinkState::kOpen) open_.emplace(key, link.connector);
  return link;
}

void FaceTest::forget(const CellId cell) {
  if (!subdivision_.cell(cell).solid()) return;
  for (const CellId next : subdivision_.cell(cell).neighbours) open_.erase(link_key(cell, next));
}

Link FaceTest::test_face(const CellId a, const CellId b) {
  ++statistics_.faces_tested;
  const Cell& first = subdivision_.cell(a);
  const Cell& second = subdivision_.cell(b);
  Axis axis = kNoAxis;
  adjacent(first.box, second.box, axis);
  Extent face = common_face(first.box, second.box, axis);
  if (!subdivision_.space().rotation) face.size[kTheta] = 0;
  if (first.label == Label::kFree || second.label == Label::kFree) {
    const CellSpace& space = subdivision_.space();
    const Vec2 t = position_of(space, middle(face.low[kX], face.size[kX]),
                               middle(face.low[kY], face.size[kY]));
    return {LinkState::kOpen, {t, middle(face.low[kTheta], face.size[kTheta])}};
  }
  const ConstraintView left = subdivision_.undecided(a);
  const ConstraintView right = subdivision_.undecided(b);
  const ConstraintView list = left.constraints.size() <= right.constraints.size() ? left : right;
  if (const auto connector = quick_connector(a, b, face, list))
    return {LinkState::kOpen, *connector};
  const std::size_t before = blocked_.size();
  int budget = kFaceBudget;
  const Link link = label_face(face, list, kFaceDepth, budget);
  if (link.state != LinkState::kBlocked) blocked_.resize(before);
  for (std::size_t i = before; i < blocked_.size(); ++i) blocked_[i].flat = axis;
  return link;
}

// Points worth a try: the face's centre and the guards' projections, at the face's central angle.
std::optional<Connector> FaceTest::quick_connector(const CellId a, const CellId b,
                                                   const Extent& face, const ConstraintView& list) {
  const CellSpace& space = subdivision_.space();
  const pdg::Motion m = motion_of(space, face);
  posed_.turn_to(rotation_of(space, face));
  const auto clamped = [&](const Vec2 p) {
    return Vec2{std::clamp(p.x, m.t.x - m.g1.x, m.t.x + m.g1.x),
                std::clamp(p.y, m.t.y - m.g2.y, m.t.y + m.g2.y)};
  };
  const Vec2 ga = subdivision_.guard(a);
  const Vec2 gb = subdivision_.guard(b);
  for (const Vec2 p : {clamped(0.5 * (ga + gb)), clamped(ga), clamped(gb), m.t})
    if (is_free(labeller_.tree(), posed_, p, space.domain.reach, list))
      return Connector{p, middle(face.low[kTheta], face.size[kTheta])};
  return std::nullopt;
}

Link FaceTest::label_face(const Extent& face, const ConstraintView& parent, const int depth,
                          int& budget) {
  --budget;
  const CellSpace& space = subdivision_.space();
  const pdg::Motion motion = motion_of(space, face);
  posed_.turn_to(rotation_of(space, face));
  Classification found = classify(labeller_, motion, posed_, parent, kFaceQuestions, scratch_);
  const std::uint64_t turns = middle(face.low[kTheta], face.size[kTheta]);
  if (found.label == Label::kFree) return {LinkState::kOpen, {motion.t, turns}};
  if (found.label == Label::kStar) return {LinkState::kOpen, {found.guard, turns}};
  if (found.label == Label::kFull) {
    FullClaim& claim = blocked_.emplace_back();
    claim.box = face;
    claim.joint = found.joint.has_value();
    claim.witness = found.witness;
    if (found.joint) claim.proof = std::move(*found.joint);
    return {LinkState::kBlocked, {}};
  }
  const Axis axis = widest_axis(motion, found.turning_radius, face);
  if (depth == 0 || budget <= 0 || axis == kNoAxis) return {};
  LinkState state = LinkState::kBlocked;
  for (const int half : {0, 1}) {
    Extent part = face;
    part.size[axis] /= 2;
    if (half == 1) part.low[axis] += part.size[axis];
    const Link link = label_face(part, view(found.undecided), depth - 1, budget);
    if (link.state == LinkState::kOpen) return link;
    if (link.state == LinkState::kDoubtful) state = LinkState::kDoubtful;
  }
  return {state, {}};
}

}  // namespace planner
