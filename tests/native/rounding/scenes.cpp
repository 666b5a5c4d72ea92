// Whole scenes: labels of leaves with lists handed down from the root, STAR, joint FULL, blocked
// faces and connectors.
#include <algorithm>

#include "claims.hpp"
#include "families.hpp"
#include "planar_planner/native/face.hpp"

namespace rounding {

namespace {

using planner::CellId;
using planner::Label;

// Splits MIXED leaves, mostly among the latest, or always the one that holds one point.
void grow(Random& random, planner::Subdivision& subdivision, const int rounds) {
  std::array<std::uint64_t, 3> point{};
  for (std::uint64_t& x : point) x = random.bits() >> 4U;
  if (!subdivision.space().rotation) point[planner::kTheta] = 0;
  const bool deep = random.one_in(3);
  std::vector<CellId> mixed;
  for (int round = 0; round < rounds; ++round) {
    mixed.clear();
    const auto divisible = [&](const CellId id) {
      return subdivision.cell(id).label == Label::kMixed && subdivision.divisible(id, 0.0);
    };
    for (CellId id = 0; id < subdivision.size(); ++id)
      if (divisible(id)) mixed.push_back(id);
    if (mixed.empty()) return;
    CellId next = mixed.back();
    if (deep && divisible(subdivision.locate(point)))
      next = subdivision.locate(point);
    else if (random.one_in(3))
      next = mixed[static_cast<std::size_t>(random.pick(0, static_cast<int>(mixed.size()) - 1))];
    subdivision.split(next);
  }
}

struct Tallies {
  Tally leaf{.family = "leaf, end to end"};
  Tally star{.family = "STAR"};
  Tally joint{.family = "joint FULL"};
  Tally link{.family = "face between leaves"};
};

void check_leaves(const World& world, const planner::Subdivision& subdivision, Tallies& out) {
  for (CellId id = 0; id < subdivision.size(); ++id) {
    const planner::Cell& cell = subdivision.cell(id);
    const exact::Box box = exact::box_of(world.space, planner::extent_of(cell.box));
    ++out.leaf.inputs;
    if (cell.label == Label::kFree) out.leaf.claim(confirm_free(world, box));
    if (cell.label == Label::kFull && !cell.joint)
      out.leaf.claim(confirm_full(world, subdivision.claim(id), box));
    if (cell.label == Label::kFull && cell.joint)
      out.joint.claim(confirm_full(world, subdivision.claim(id), box));
    if (cell.label == Label::kStar)
      out.star.claim(confirm_star(world, subdivision.guard(id), box));
  }
}

void check_faces(World& world, planner::Subdivision& subdivision, Tallies& out) {
  planner::FaceTest faces(subdivision, world.labeller, world.statistics);
  for (CellId a = 0; a < subdivision.size(); ++a) {
    const planner::Cell& cell = subdivision.cell(a);
    if (cell.label != Label::kStar) continue;
    for (const CellId b : cell.neighbours) {
      const Label other = subdivision.cell(b).label;
      if (!subdivision.cell(b).solid() || (b < a && other == Label::kStar)) continue;
      ++out.link.inputs;
      const std::size_t before = faces.blocked().size();
      const planner::Link link = faces.test(a, b);
      for (std::size_t i = before; i < faces.blocked().size(); ++i) {
        const planner::FullClaim& claim = faces.blocked()[i];
        out.link.claim(confirm_full(world, claim, exact::box_of(world.space, claim.box)));
      }
      if (link.state != planner::LinkState::kOpen) continue;
      exact::Box here;
      here.t = {exact::Ball(link.connector.t.x), exact::Ball(link.connector.t.y)};
      here.half = {exact::Ball(), exact::Ball(1.0)};
      here.rotation = world.space.rotation
                          ? exact::sine_cosine_of_turns(2 * (link.connector.turns % planner::kUnit))
                          : exact::sine_cosine(exact::Ball(world.space.fixed_theta));
      out.link.claim(confirm_free(world, here));
    }
  }
}

}  // namespace

// STAR and joint FULL are tested where nothing simpler decides: their inputs are counted by the core.
std::vector<Tally> scenes(const Request& request) {
  Random random(request.seed);
  Tallies out;
  const auto enough = [&] {
    return std::min({out.leaf.inputs, out.star.inputs, out.link.inputs}) >= request.inputs;
  };
  while (!enough()) {
    World world(any_scene(random, request.adversarial), random.between(-10.0, 10.0));
    planner::Subdivision subdivision(world.space, world.labeller, world.statistics);
    grow(random, subdivision, random.pick(10, request.adversarial ? 150 : 80));
    out.star.inputs += world.statistics.star_tests;
    out.joint.inputs += world.statistics.star_tests + world.statistics.joint_cells;
    check_leaves(world, subdivision, out);
    check_faces(world, subdivision, out);
  }
  return {out.leaf, out.star, out.joint, out.link};
}

}  // namespace rounding
