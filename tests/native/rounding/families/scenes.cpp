// Whole scenes: labels of leaves with lists handed down from the root, STAR, joint FULL, blocked
// faces and connectors.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "claims.hpp"
#include "families.hpp"
#include "planar_planner/native/cells/face.hpp"

namespace rounding {

namespace {

using planner::CellId;
using planner::Label;

using Point = std::array<std::uint64_t, 3>;

bool free_at(World& world, const Point& p) {
  const planner::Extent here{p, {0, 0, 0}};
  planner::ConstraintList root;
  world.labeller.root_list(root);
  const planner::LabelResult result = world.labeller.label(
      planner::motion_of(world.space, here),
      world.posed_at(planner::rotation_of(world.space, here)), planner::view(root));
  return result.label == Label::kFree;
}

// Between a free configuration and one that is not, down to neighbouring dyadic coordinates: there
// the cells are decided, or not, by the last digits. At a random angle, or at a quarter turn.
Point point_of_contact(Random& random, World& world) {
  Point free{}, other{};
  const auto any = [&](Point& p) {
    p[planner::kX] = random.bits() >> 4U;
    p[planner::kY] = random.bits() >> 4U;
  };
  const bool upright = random.one_in(2);
  const std::uint64_t angle =
      upright ? planner::kUnit / 4 * (random.bits() % 4) : random.bits() >> 4U;
  free[planner::kTheta] = other[planner::kTheta] = world.space.rotation ? angle : 0;
  for (int i = 0; i < 20 && !free_at(world, free); ++i) any(free);
  for (int i = 0; i < 20 && free_at(world, other); ++i) any(other);
  for (int i = 0; i < 60; ++i) {
    Point middle = free;
    for (const planner::Axis axis : {planner::kX, planner::kY})
      middle[axis] = free[axis] / 2 + other[axis] / 2;
    (free_at(world, middle) ? free : other) = middle;
  }
  return free;
}

Point dyadic(const World& world, const planner::Configuration& q) {
  const auto count = [](const double part) {
    return static_cast<std::uint64_t>(std::clamp(part, 0.0, 1.0 - 0x1p-53) * 0x1p60);
  };
  const Vec2 t = planner::to_planner(world.problem, {q.x, q.y}) - world.space.domain.low;
  const double turns = q.theta / (2.0 * std::numbers::pi);
  return {count(t.x / world.space.domain.size.x), count(t.y / world.space.domain.size.y),
          world.space.rotation ? count(turns - std::floor(turns)) : 0};
}

// Splits MIXED leaves, mostly among the latest; or MIXED and STAR ones, always that of one point.
void grow(Random& random, World& world, const Stage& stage, planner::Subdivision& subdivision,
          const int rounds) {
  if (random.one_in(2)) {
    const Point point = stage.critical && !random.one_in(4) ? dyadic(world, *stage.critical)
                                                            : point_of_contact(random, world);
    for (int round = 0; round < rounds; ++round) {
      const CellId id = subdivision.locate(point);
      if (!subdivision.divisible(id, 0.0)) return;
      subdivision.split(id);
    }
    return;
  }
  std::vector<CellId> mixed;
  for (int round = 0; round < rounds; ++round) {
    mixed.clear();
    for (CellId id = 0; id < subdivision.size(); ++id)
      if (subdivision.cell(id).label == Label::kMixed && subdivision.divisible(id, 0.0))
        mixed.push_back(id);
    if (mixed.empty()) return;
    const auto any = static_cast<std::size_t>(random.pick(0, static_cast<int>(mixed.size()) - 1));
    subdivision.split(random.one_in(3) ? mixed[any] : mixed.back());
  }
}

struct Tallies {
  Tally leaf{.family = "leaf, end to end"};
  Tally star{.family = "STAR"};
  Tally joint{.family = "joint FULL"};
  // The same labels as of cells and of `face`, where missing margins show; here they seldom do.
  Tally link{.family = "face between leaves", .leans_on_margin = false};
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
    if (cell.label == Label::kStar) out.star.claim(confirm_star(world, subdivision.guard(id), box));
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

// STAR and joint FULL are tested where nothing simpler decides: their inputs are counted by the
// core.
std::vector<Tally> scenes(const Request& request) {
  Random random(request.seed);
  Tallies out;
  const auto enough = [&] {
    return std::min({out.leaf.inputs, out.star.inputs, out.link.inputs}) >= request.inputs;
  };
  while (!enough()) {
    const Stage stage = any_stage(random, request.adversarial);
    const double theta =
        stage.critical && random.one_in(2) ? stage.critical->theta : random.between(-10.0, 10.0);
    World world(stage.scene, theta);
    planner::Subdivision subdivision(world.space, world.labeller, world.statistics);
    grow(random, world, stage, subdivision,
         request.adversarial ? random.pick(60, 200) : random.pick(10, 80));
    out.star.inputs += world.statistics.star_tests;
    out.joint.inputs += world.statistics.star_tests + world.statistics.joint_cells;
    check_leaves(world, subdivision, out);
    check_faces(world, subdivision, out);
  }
  return {out.leaf, out.star, out.joint, out.link};
}

}  // namespace rounding
