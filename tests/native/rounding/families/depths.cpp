// Results that are plain doubles, against the errors that are stated for them; and the bounds on
// motion, which must hold as they are.
#include <algorithm>
#include <cmath>

#include "families.hpp"
#include "generate.hpp"
#include "pdg/native/depth/displacement.hpp"
#include "pdg/native/depth/generalized_depth.hpp"
#include "pdg/native/geometry/motion_bound.hpp"
#include "pdg/native/tolerances.hpp"
#include "piece_sets.hpp"
#include "truth/exact.hpp"

namespace rounding {

namespace {

using exact::Ball;
using exact::Piece;

double diameter(const ConvexPolygon& a, const ConvexPolygon& b) {
  ConvexPolygon all = a;
  all.insert(all.end(), b.begin(), b.end());
  double most = 0.0;
  for (const Vec2 p : all)
    for (const Vec2 q : all) most = std::max(most, pdg::norm(p - q));
  return most;
}

double largest_coordinate(const ConvexPolygon& a) {
  double most = 0.0;
  for (const Vec2 p : a) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  return most;
}

Ball point_distance(const exact::Vector& p, const Piece& edges) {
  Ball nearest;
  for (std::size_t k = 0; k < edges.vertices.size(); ++k) {
    const exact::Vector from = p - edges.vertices[k];
    const Ball part = dot(from, edges.along[k]);
    const Ball whole = dot(edges.along[k], edges.along[k]);
    Ball here = absolute(dot(edges.normals[k], from));
    if (!part.certainly_positive())
      here = length(from);
    else if (!(whole - part).certainly_positive())
      here = length(from - edges.along[k]);
    nearest = k == 0 ? here : least(nearest, here);
  }
  return nearest;
}

// The distance of disjoint pieces is attained at a vertex of one of them.
Ball distance(const Piece& a, const Piece& b) {
  Ball nearest = point_distance(a.vertices[0], b);
  for (const exact::Vector& p : a.vertices) nearest = least(nearest, point_distance(p, b));
  for (const exact::Vector& p : b.vertices) nearest = least(nearest, point_distance(p, a));
  return nearest;
}

exact::Box origin() {
  exact::Box box;
  box.rotation = box.half = {Ball(), Ball(1.0)};
  return box;
}

// The polygon at a configuration, rounded: then it is what is given.
ConvexPolygon rounded(const ConvexPolygon& a, const pdg::Pose& pose) {
  return pdg::placed(a, pose);
}

void translational(Random& random, const bool adversarial, Tally& tally) {
  const SetCase c = set_case(random, adversarial);
  const ConvexPolygon a = rounded(c.a.polygons[0], c.cell.centre);
  const ConvexPolygon& b = c.b.polygons[0];
  if (!strictly_convex(a)) return;
  ++tally.inputs;
  const Piece exact_a = exact::framed(pdg::Frame{}, a);
  const Piece exact_b = exact::framed(pdg::Frame{}, b);
  const Ball depth = least_depth(exact_a, exact_b, origin());
  const pdg::TranslationalDepth found = pdg::translational_depth(a, b);
  // Predicates on doubles of very different size need more digits than a ball has: no claim then.
  if (depth.certainly_positive() || depth.certainly_negative())
    tally.claim(found.state ==
                (depth.certainly_positive() ? pdg::PairState::kOverlap : pdg::PairState::kApart));
  if (found.state == pdg::PairState::kOverlap)
    tally.near(found.depth, depth, pdg::kDepthErrorUnits * pdg::kUnitRoundoff * diameter(a, b));
  if (found.state == pdg::PairState::kApart)
    tally.near(-found.depth, distance(exact_a, exact_b),
               pdg::kDepthErrorUnits * pdg::kUnitRoundoff *
                   (diameter(a, b) + largest_coordinate(a) + largest_coordinate(b)));
}

void lower_bound(Random& random, const bool adversarial, Tally& tally) {
  const SetCase c = set_case(random, adversarial);
  ++tally.inputs;
  const exact::Box here = box_of(c.cell.centre, {});
  Ball deepest;
  double size = 0.0;
  bool convex = true;
  for (const ConvexPolygon& a : c.a.polygons) {
    convex = convex && strictly_convex(pdg::placed(a, c.cell.centre));
    for (const ConvexPolygon& b : c.b.polygons) {
      deepest = greatest(deepest, least_depth(exact::framed(pdg::Frame{}, a),
                                              exact::framed(pdg::Frame{}, b), here));
      size = std::max(size, diameter(a, b));
    }
  }
  const double placing = c.a.radius + pdg::norm(c.cell.centre.t);
  const double found = pdg::generalized_depth_lower_bound(c.a, c.b, c.cell.centre).depth;
  const double bound = pdg::kDepthErrorUnits * pdg::kUnitRoundoff * (size + 2.0 * placing);
  tally.not_above(found, deepest, bound);
  // Far from the origin rounding may spoil a piece's convexity: the bound holds, but says less.
  if (convex) tally.not_below(found, deepest, bound);
}

void motion_bounds(Random& random, const bool adversarial, Tally& tally) {
  const double scale = adversarial ? random.magnitude(1e-100, 1e140) : 1.0;
  const double widest = adversarial && random.one_in(3) ? 10.0 : 3.2;
  const pdg::HalfExtents h{random.one_in(4) ? 0.0 : scale * random.magnitude(1e-9, 10.0),
                           random.one_in(4) ? 0.0 : scale * random.magnitude(1e-9, 10.0),
                           random.one_in(4) ? 0.0 : random.magnitude(1e-9, widest)};
  const double r = random.one_in(8) ? 0.0 : scale * random.magnitude(1e-3, 1e3);
  ++tally.inputs;
  const exact::Ball x(h.x), y(h.y), angle(h.theta), radius(r);
  const Ball straight = square_root(x * x + y * y);
  const Ball turn = exact::pi().middle < angle.middle ? exact::pi() : angle;
  const Ball chord = Ball(2.0) * exact::sine_cosine(turn * Ball(0.5)).sine;
  const std::pair<double, Ball> bounds[] = {
      {pdg::sum_bound(h, r), x + y + radius * angle},
      {pdg::arc_bound(h, r), straight + radius * angle},
      {pdg::displacement_bound(h, r), straight + radius * chord}};
  for (const auto& [computed, truth] : bounds) {
    if (truth.value() == 0.0) continue;
    tally.claim((Ball(computed) - truth).certainly_not_negative());
    // Not needlessly large either: within twice the padding.
    tally.not_above(computed, truth, 64.0 * pdg::kUnitRoundoff * truth.value());
  }
}

void displacements(Random& random, const bool adversarial, Tally& tally) {
  const SetCase c = set_case(random, adversarial);
  const Move move = move_of(random, c, adversarial);
  ++tally.inputs;
  tally.near(pdg::displacement(c.a, move.from, move.to), displacement_of(c.a, move),
             displacement_error(c.a, move));
}

}  // namespace

std::vector<Tally> depths(const Request& request) {
  Random random(request.seed);
  std::vector<Tally> out{{.family = "PD^t", .leans_on_margin = false},
                         {.family = "PD^g lower bound", .leans_on_margin = false},
                         {.family = "bounds of motion"},
                         {.family = "displacement", .leans_on_margin = false}};
  while (out[0].inputs < request.inputs) translational(random, request.adversarial, out[0]);
  while (out[1].inputs < request.inputs) lower_bound(random, request.adversarial, out[1]);
  while (out[2].inputs < request.inputs) motion_bounds(random, request.adversarial, out[2]);
  while (out[3].inputs < request.inputs) displacements(random, request.adversarial, out[3]);
  return out;
}

}  // namespace rounding
