// The C-obstacle query of the depth library, by all three methods.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "pdg/native/depth/translational_depth.hpp"
#include "piece_sets.hpp"

namespace rounding {

namespace {

using exact::Ball;

exact::Piece plain(const ConvexPolygon& polygon) {
  return exact::framed(pdg::Frame{}, polygon);
}

// Largest axis value at a configuration, and the way of its axis: to make contacts with.
void touch(Random& random, SetCase& c, const std::vector<ConvexPolygon>& a) {
  for (int round = 0; round < 2; ++round) {
    const ConvexPolygon here = pdg::placed(a[0], c.cell.centre);
    if (!strictly_convex(here)) return;
    const pdg::TranslationalDepth found = pdg::translational_depth(here, c.b.polygons[0]);
    const double scatter = random.one_in(3) ? 0.0 : random.between(-3.0, 3.0) * 64.0 * 0x1p-53;
    const double by = found.depth + scatter * pdg::norm(c.cell.centre.t);
    c.cell.centre.t = c.cell.centre.t + by * found.direction;
  }
  c.cell.centre.t = {nudged(c.cell.centre.t.x, random.pick(-2, 2)),
                     nudged(c.cell.centre.t.y, random.pick(-2, 2))};
}

}  // namespace

SetCase set_case(Random& random, const bool adversarial) {
  const double scale = adversarial && random.one_in(2) ? random.magnitude(1e-100, 1e140) : 1.0;
  const double far = adversarial && random.one_in(4) ? random.magnitude(1.0, 1e9) : 0.0;
  const Vec2 origin = scale * far * Vec2{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
  const auto body = [&](const Vec2 centre) {
    std::vector<ConvexPolygon> polygons;
    for (int i = random.pick(1, 2); i > 0; --i) {
      const Vec2 at = centre + scale * Vec2{random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
      polygons.push_back(
          polygon(random, any_shape(random, adversarial), scale * random.magnitude(0.05, 1.0), at));
    }
    return polygons;
  };
  SetCase c;
  std::vector<ConvexPolygon> a = body({});
  c.b = pdg::make_piece_set(body(origin));
  const double theta =
      random.one_in(3) ? random.pick(-4, 4) * std::numbers::pi / 4 : random.between(-4.0, 4.0);
  const double turns = adversarial && random.one_in(4) ? random.pick(-150000, 150000) : 0;
  c.cell.centre = {origin + scale * Vec2{random.between(-0.7, 0.7), random.between(-0.7, 0.7)},
                   theta + 2.0 * std::numbers::pi * turns};
  if (adversarial && !random.one_in(4)) touch(random, c, a);
  c.a = pdg::make_piece_set(std::move(a));
  const auto width = [&] {
    return random.one_in(4) ? 0.0 : random.magnitude(adversarial ? 1e-17 : 1e-4, 0.2);
  };
  c.cell.half = {scale * width(), scale * width(), random.one_in(8) ? 20.0 * width() : width()};
  return c;
}

exact::Box box_of(const pdg::Pose& centre, const pdg::HalfExtents& half) {
  exact::Box box;
  box.t = {Ball(centre.t.x), Ball(centre.t.y)};
  box.g1 = {Ball(half.x), Ball()};
  box.g2 = {Ball(), Ball(half.y)};
  box.rotation = exact::sine_cosine(Ball(centre.theta));
  const Ball angle(half.theta);
  box.h = exact::pi().middle < angle.middle ? exact::pi() : angle;
  box.half = exact::sine_cosine(box.h);
  return box;
}

std::vector<Tally> queries(const Request& request) {
  Random random(request.seed);
  std::vector<Tally> out{{.family = "query, published"},
                         {.family = "query, displacement"},
                         {.family = "query, per normal"}};
  while (out[0].inputs < request.inputs) {
    const SetCase c = set_case(random, request.adversarial);
    for (std::size_t method = 0; method < 3; ++method) {
      Tally& tally = out[method];
      ++tally.inputs;
      const pdg::CObstacleVerdict verdict =
          pdg::c_obstacle_query(c.a, c.b, c.cell, static_cast<pdg::QueryMethod>(method));
      if (verdict.piece_a < 0) continue;
      const exact::Piece a = plain(c.a.polygons[static_cast<std::size_t>(verdict.piece_a)]);
      const exact::Piece b = plain(c.b.polygons[static_cast<std::size_t>(verdict.piece_b)]);
      const exact::Box box = box_of(c.cell.centre, c.cell.half);
      if (verdict.full) tally.claim(overlap(a, b, box));
      // The margin is a lower bound as it stands, also where it proves nothing.
      Ball truth;
      if (method == 2) {
        truth = least_depth(a, b, box);
      } else {
        Ball r = reach(a);
        if (method == 0)
          for (const ConvexPolygon& polygon : c.a.polygons) r = greatest(r, reach(plain(polygon)));
        const Ball x(c.cell.half.x), y(c.cell.half.y), angle(c.cell.half.theta);
        const Ball turn = Ball(2.0) * exact::sine_cosine(box.h * Ball(0.5)).sine;
        const Ball motion = method == 0 ? x + y + r * angle : square_root(x * x + y * y) + r * turn;
        truth = least_depth(a, b, box_of(c.cell.centre, {})) - motion;
      }
      tally.claim((truth - Ball(verdict.margin)).certainly_not_negative());
    }
  }
  return out;
}

}  // namespace rounding
