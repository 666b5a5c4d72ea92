#include "generate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pdg/native/geometry/convex_piece.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/separation/separation.hpp"
#include "pdg/native/tolerances.hpp"

namespace rounding {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

ConvexPolygon ellipse(Random& random, const int count, const double aspect) {
  ConvexPolygon out;
  const double phase = random.between(0.0, kTurn);
  for (int i = 0; i < count; ++i) {
    const double angle = phase + (i + random.between(0.0, 0.7)) * kTurn / count;
    out.push_back({std::cos(angle), aspect * std::sin(angle)});
  }
  return out;
}

ConvexPolygon raw(Random& random, const Shape shape) {
  switch (shape) {
    case Shape::kSliver:
      return ellipse(random, random.pick(3, 4), random.magnitude(1e-13, 1e-9));
    case Shape::kRectangle: {
      const double x = std::ldexp(1.0, -random.pick(0, 3));
      const double y = std::ldexp(1.0, -random.pick(0, 3));
      return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    }
    case Shape::kTrapezoid: {
      const double off = random.magnitude(1e-16, 1e-6) * random.sign();
      const double y = random.between(0.1, 1.0);
      return {{-1.0, -y}, {1.0 + off, -y}, {1.0, y}, {-1.0, y * (1.0 + off)}};
    }
    case Shape::kBlunt: {
      ConvexPolygon out = ellipse(random, random.pick(3, 5), 1.0);
      const Vec2 p = out[0];
      const double by = random.magnitude(1e-16, 1e-13);
      const Vec2 forward = out[1] - p;
      out.insert(out.begin() + 1, p + by * forward + 0.3 * by * p);
      return out;
    }
    default:
      return ellipse(random, random.pick(3, 6), random.between(0.3, 1.0));
  }
}

// Separation of the pieces at the target by the core's own axes, and the axis that attains it: a
// guess, to make contacts with.
Vec2 contact(const PairCase& c) {
  const pdg::ConvexPiece a = pdg::make_piece(c.a, {{}, c.frame.exponent});
  const pdg::ConvexPiece b = pdg::make_piece(c.b, c.frame);
  const pdg::Rotation r = planner::rotation_of_turns(c.target[2]);
  const Vec2 t = planner::position_of(c.space, c.target[0], c.target[1]);
  double most = -INFINITY;
  Vec2 axis;
  for (const pdg::Edge& edge : b.edges) {
    double s = INFINITY;
    for (const pdg::Edge& v : a.edges)
      s = std::min(s, dot(edge.normal, pdg::rotate(r, v.vertex) + t) - edge.offset);
    if (s > most) most = s, axis = -edge.normal;
  }
  for (const pdg::Edge& edge : a.edges) {
    const Vec2 n = pdg::rotate(r, edge.normal);
    double s = INFINITY;
    for (const pdg::Edge& v : b.edges) s = std::min(s, dot(n, v.vertex - t) - edge.offset);
    if (s > most) most = s, axis = n;
  }
  return most * axis;  // how far b is beyond a
}

}  // namespace

bool strictly_convex(const ConvexPolygon& p) {
  if (p.size() < 3) return false;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 2; j < p.size(); ++j)
      if (pdg::orient2d(p[i], p[(i + 1) % p.size()], p[(i + j) % p.size()]) <= 0) return false;
  return true;
}

double Random::magnitude(const double low, const double high) {
  return std::exp(between(std::log(low), std::log(high)));
}

double nudged(double x, const int steps) {
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps > 0 ? INFINITY : -INFINITY);
  return x;
}

ConvexPolygon polygon(Random& random, const Shape shape, const double size, const Vec2 centre) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    ConvexPolygon out = raw(random, attempt < 19 ? shape : Shape::kRectangle);
    const bool upright = shape == Shape::kRectangle || random.one_in(4);
    const double angle = upright ? 0.0 : random.between(0.0, kTurn);
    const pdg::Rotation turn{std::cos(angle), std::sin(angle)};
    const double scale = shape == Shape::kSmall ? 1e-9 * size : size;
    for (Vec2& p : out) p = centre + scale * pdg::rotate(turn, p);
    if (random.one_in(3)) std::rotate(out.begin(), out.begin() + 1, out.end());
    if (strictly_convex(out)) return out;
  }
  // Rounding at the centre's magnitude leaves no room for the shape: one that fits.
  const double step = 8.0 * std::max(size, 0x1p-50 * (std::abs(centre.x) + std::abs(centre.y)));
  return {centre, {centre.x + step, centre.y}, {centre.x, centre.y + step}};
}

Shape any_shape(Random& random, const bool adversarial) {
  if (!adversarial) return random.one_in(8) ? Shape::kRectangle : Shape::kRound;
  return static_cast<Shape>(random.pick(0, static_cast<int>(Shape::kCount) - 1));
}

PairCase pair_case(Random& random, const bool adversarial) {
  PairCase c;
  const bool odd_scale = adversarial && random.one_in(3);
  const double scale = odd_scale ? random.magnitude(1e-9, 1e9) : random.magnitude(0.1, 10.0);
  const double far = adversarial && random.one_in(4) ? random.magnitude(1.0, 1e9) : 0.0;
  c.frame.origin = {scale * far * random.between(-1.0, 1.0),
                    scale * far * random.between(-1.0, 1.0)};
  c.frame.exponent = -std::ilogb(scale) - 1;
  const double unit = std::ldexp(1.0, -c.frame.exponent);  // of the frame, in the user's
  if (random.one_in(4)) {
    c.space.domain.low = {-1.0, -1.0};
    c.space.domain.size = {2.0, 2.0};
  } else {
    c.space.domain.low = {random.between(-1.0, -0.2), random.between(-1.0, -0.2)};
    c.space.domain.size = {random.between(0.5, 2.0), random.between(0.5, 2.0)};
  }
  const planner::Domain& d = c.space.domain;
  const Vec2 high = d.low + d.size;
  c.space.domain.reach = pdg::norm({std::max(std::abs(d.low.x), std::abs(high.x)),
                                    std::max(std::abs(d.low.y), std::abs(high.y))}) *
                         pdg::kRadiusPadding;
  const double robot = unit * random.magnitude(adversarial ? 1e-3 : 0.05, adversarial ? 10.0 : 1.0);
  const double off = random.one_in(3) ? robot * random.between(1.0, 5.0) : 0.3 * robot;
  c.a = polygon(random, any_shape(random, adversarial), robot,
                {off * random.between(-1.0, 1.0), off * random.between(-1.0, 1.0)});
  const double obstacle =
      unit * random.magnitude(adversarial ? 1e-3 : 0.05, adversarial ? 10.0 : 1.0);
  c.b = polygon(random, any_shape(random, adversarial), obstacle,
                c.frame.origin + unit * Vec2{random.between(-1.0, 1.0), random.between(-1.0, 1.0)});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Some low levels, so that the target is a corner of many cells; the seam now and then.
    const int level = random.one_in(3) ? random.pick(1, 8) : random.pick(9, planner::kMaxLevel);
    c.target[axis] = (random.bits() >> 4U) & ~((planner::kUnit >> level) - 1);
    if (axis == planner::kTheta && random.one_in(6))
      c.target[axis] = random.one_in(2) ? 0 : planner::kUnit - (planner::kUnit >> level);
  }
  if (!adversarial || random.one_in(5)) return c;
  // Into contact, beyond it or short of it by a few rounding errors, and off by single ulps.
  for (int round = 0; round < 2; ++round) {
    const Vec2 gap = contact(c);
    const double scatter = random.one_in(3) ? 0.0 : random.between(-3.0, 3.0) * 64.0 * 0x1p-53;
    const double size = pdg::norm(gap);
    const double keep = size > 0.0 ? scatter / size : 0.0;
    const Vec2 shift = unit * ((1.0 - keep) * gap);
    ConvexPolygon moved = c.b;
    for (Vec2& p : moved) p = p - shift;
    if (strictly_convex(moved)) c.b = moved;
  }
  if (random.one_in(2)) {
    ConvexPolygon moved = c.b;
    for (Vec2& p : moved) p = {nudged(p.x, random.pick(-2, 2)), nudged(p.y, random.pick(-2, 2))};
    if (strictly_convex(moved)) c.b = moved;
  }
  return c;
}

planner::CellBox cell_at(const std::array<std::uint64_t, 3>& target,
                         const std::array<int, 3>& levels) {
  planner::CellBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.level[axis] = static_cast<std::uint8_t>(levels[axis]);
    box.low[axis] = target[axis] & ~(box.size(axis) - 1);
  }
  return box;
}

}  // namespace rounding
