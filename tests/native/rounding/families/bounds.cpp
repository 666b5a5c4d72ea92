// FREE by bounding circles of pieces and boxes of the obstacle tree, over cells, faces and
// segments.
#include <algorithm>
#include <cmath>

#include "families.hpp"
#include "generate.hpp"
#include "pdg/native/tolerances.hpp"
#include "planar_planner/native/configurations/nearby.hpp"
#include "posed.hpp"
#include "truth/exact.hpp"

namespace rounding {

namespace {

// No workspace: nothing lies outside.
const planner::PolygonSet kNothing;

planner::ObstacleTree tree_of(planner::PolygonSet& set, const PairCase& c) {
  set.append({{c.b}});
  return {{set, kNothing}, c.frame, {}};
}

// The way from the obstacle's circle or box to the translations' rectangle, and what is left of it
// beyond the radii.
struct Gap {
  Vec2 way;
  double distance;
};

Gap gap_of(const PairCase& c, const pdg::ConvexPiece& a, const pdg::Motion& m,
           const pdg::Rotation r, const bool by_box) {
  const auto beyond = [](const double x, const double width) {
    return std::copysign(std::max(std::abs(x) - width, 0.0), x);
  };
  if (!by_box) {
    const pdg::ConvexPiece b = pdg::make_piece(c.b, c.frame);
    const Vec2 d = m.t + pdg::rotate(r, a.centre) - b.centre;
    return {{beyond(d.x, m.g1.x), beyond(d.y, m.g2.y)}, planner::circle_distance(m, r, a, b)};
  }
  planner::PolygonSet set;
  const planner::TreeNode node = tree_of(set, c).node(0);
  const Vec2 d = m.t - 0.5 * (node.low + node.high);
  const Vec2 half = 0.5 * (node.high - node.low);
  return {{beyond(d.x, m.g1.x + half.x), beyond(d.y, m.g2.y + half.y)},
          planner::distance_to_box(m, node.low, node.high) - a.reach};
}

// Moves b until the gap is closed, up to a few rounding errors.
void close_gap(Random& random, PairCase& c, const pdg::Motion& m, const pdg::Rotation r) {
  const pdg::ConvexPiece a = pdg::make_piece(c.a, exact::robot_frame(c.frame));
  const bool by_box = random.one_in(2);
  const double scatter = random.one_in(3) ? 0.0 : random.between(-2.0, 2.0) * 0x1p-53;
  for (int round = 0; round < 3; ++round) {
    const Gap gap = gap_of(c, a, m, r, by_box);
    const double size = pdg::norm(gap.way);
    if (!(size > 0.0)) return;
    const double by = std::ldexp((gap.distance + scatter) / size, -c.frame.exponent);
    ConvexPolygon moved = c.b;
    for (Vec2& p : moved) p = p + by * gap.way;
    if (strictly_convex(moved)) c.b = moved;
  }
}

// So small that the padding of the radii does not cover the rounding of the places.
void shrink(PairCase& c) {
  for (Vec2& p : c.a) p = 0x1p-24 * p;
  ConvexPolygon small = c.b;
  for (Vec2& p : small) p = c.b[0] + 0x1p-24 * (p - c.b[0]);
  if (strictly_convex(small)) c.b = small;
}

planner::Extent any_extent(Random& random, const PairCase& c, const bool adversarial) {
  const int deepest = adversarial ? planner::kMaxLevel : 12;
  planner::Extent e = planner::extent_of(cell_at(
      c.target, {random.pick(1, deepest), random.pick(1, deepest), random.pick(2, deepest)}));
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (random.one_in(4)) e.size[axis] = 0;
  return e;
}

}  // namespace

std::vector<Tally> bounds(const Request& request) {
  Random random(request.seed);
  Tally circles{.family = "circles FREE"};
  Tally boxes{.family = "tree box FREE"};
  while (circles.inputs < request.inputs) {
    PairCase c = pair_case(random, request.adversarial);
    if (request.adversarial && random.one_in(2)) shrink(c);
    const planner::Extent e = any_extent(random, c, request.adversarial);
    const pdg::Motion m = planner::motion_of(c.space, e);
    const pdg::Rotation r = planner::rotation_of(c.space, e);
    const pdg::ConvexPiece a = pdg::make_piece(c.a, exact::robot_frame(c.frame));
    if (request.adversarial) close_gap(random, c, m, r);
    const exact::Piece exact_a = exact::framed(exact::robot_frame(c.frame), c.a);
    const exact::Piece exact_b = exact::framed(c.frame, c.b);
    const exact::Box box = exact::box_of(c.space, e);
    ++circles.inputs;
    ++boxes.inputs;
    const pdg::ConvexPiece b = pdg::make_piece(c.b, c.frame);
    const exact::Ball between = exact::circle_distance(exact_a, exact_b, box);
    if (planner::circle_gap(m, r, a, b) >= 0.0) circles.claim(between.certainly_not_negative());
    const double unit = kSeparationUnits * pdg::kUnitRoundoff;
    circles.not_above(planner::circle_distance(m, r, a, b), between,
                      unit * (a.reach + b.reach + m.reach));
    planner::PolygonSet set;
    const planner::ObstacleTree tree = tree_of(set, c);
    const planner::TreeNode& node = tree.node(0);
    const exact::Ball beyond = exact::box_distance(
        exact::reach(exact_a), exact::low_corner(exact_b), exact::high_corner(exact_b), box);
    if (planner::node_gap(m, a.reach, node) >= 0.0) boxes.claim(beyond.certainly_not_negative());
    const double largest = std::max(std::max(std::abs(node.low.x), std::abs(node.high.x)),
                                    std::max(std::abs(node.low.y), std::abs(node.high.y)));
    boxes.not_above(planner::distance_to_box(m, node.low, node.high) - a.reach, beyond,
                    unit * (a.reach + largest + m.reach));
  }
  return {circles, boxes};
}

}  // namespace rounding
