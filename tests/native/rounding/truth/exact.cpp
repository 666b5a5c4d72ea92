#include "exact.hpp"

#include <algorithm>
#include <cmath>

#include "planar_planner/native/configurations/quarter_turn.hpp"

namespace exact {

namespace {

const Ball kHalf(0.5);

// The angle that a double means: the quarter turns that it is nearest to, or itself.
Ball meant_angle(const double theta) {
  const auto quarters = planner::quarters_of(theta);
  return quarters ? Ball(static_cast<double>(*quarters)) * pi() * kHalf : Ball(theta);
}

SineCosine meant_rotation(const double theta) {
  const auto quarters = planner::quarters_of(theta);
  return quarters ? turned({Ball(0.0), Ball(1.0)}, *quarters) : sine_cosine(Ball(theta));
}

Sinusoid in_terms_of(const Vector& axis, const Vector& p) {
  return {dot(axis, p), dot(axis, perpendicular(p))};
}

Ball at(const Sinusoid& f, const Ball& c, const Ball& s) {
  return f.v * c + f.w * s;
}

// Plainly not within h of (1, 0), by doubles with ample room: saves the exact test nearly always.
bool plainly_outside(const Ball& c, const Ball& s, const Box& box) {
  const double x = c.value();
  const double y = std::abs(s.value());
  const double room = 1e-9 * (std::abs(x) + y) + 4.0 * (c.radius + s.radius);
  const double cosine = box.half.cosine.value();
  return cosine > 0.0 && x * box.half.sine.value() - y * cosine < -room;
}

// Is the direction (c, s), of length `size`, possibly within h of (1, 0)? By the sine where h is
// below a quarter turn: a cosine does not tell 1e-17 from zero.
bool possibly_within(const Ball& c, const Ball& s, const Ball& size, const Box& box) {
  if (!box.half.cosine.certainly_positive())
    return (c - size * box.half.cosine).possibly_not_negative();
  return c.possibly_not_negative() &&
         (c * box.half.sine - absolute(s) * box.half.cosine).possibly_not_negative();
}

Ball least_at(const std::vector<Sinusoid>& all, const Ball& c, const Ball& s) {
  Ball out = at(all[0], c, s);
  for (std::size_t i = 1; i < all.size(); ++i) out = least(out, at(all[i], c, s));
  return out;
}

// Largest value over |delta| <= h of the least of the functions: at an end, at the peak of one, or
// where two neighbours on the convex ring are equal.
// `steps` are the differences from each function to the next, to full relative precision.
Ball envelope_largest(const std::vector<Sinusoid>& all, const std::vector<Sinusoid>& steps,
                      const Box& box) {
  Ball out = greatest(least_at(all, box.half.cosine, box.half.sine),
                      least_at(all, box.half.cosine, -box.half.sine));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Sinusoid& f = all[i];
    if (!plainly_outside(f.v, f.w, box)) {
      const Ball size = square_root(f.v * f.v + f.w * f.w);
      if (!size.certainly_positive())
        out = greatest(out, size);
      else if (possibly_within(f.v, f.w, size, box))
        out = greatest(out, least_at(all, f.v / size, f.w / size));
    }
    for (const double sign : {1.0, -1.0}) {
      const Ball c = Ball(sign) * steps[i].w;
      const Ball s = Ball(-sign) * steps[i].v;
      if (plainly_outside(c, s, box)) continue;
      const Ball span = square_root(c * c + s * s);
      if (possibly_within(c, s, span, box)) out = greatest(out, least_at(all, c / span, s / span));
    }
  }
  return out;
}

Ball envelope_least(const std::vector<Sinusoid>& all, const Box& box) {
  Ball out = sinusoid_least(all[0], box);
  for (const Sinusoid& f : all) out = least(out, sinusoid_least(f, box));
  return out;
}

}  // namespace

Vector framed(const pdg::Frame& frame, const pdg::Vec2 p) {
  return {scaled(Ball(p.x) - Ball(frame.origin.x), frame.exponent),
          scaled(Ball(p.y) - Ball(frame.origin.y), frame.exponent)};
}

Piece framed(const pdg::Frame& frame, const pdg::ConvexPolygon& polygon) {
  Piece out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const pdg::Vec2 p = polygon[k];
    const pdg::Vec2 q = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    out.vertices.push_back(framed(frame, p));
    const Vector along{scaled(Ball(q.x) - Ball(p.x), frame.exponent),
                       scaled(Ball(q.y) - Ball(p.y), frame.exponent)};
    const Ball size = length(along);
    out.along.push_back(along);
    out.normals.push_back({along.y / size, -along.x / size});
  }
  return out;
}

Box box_of(const planner::CellSpace& space, const planner::Extent& e) {
  const auto fraction = [](const std::uint64_t k, const int bits) {
    return scaled({static_cast<Wide>(k), 0.0}, -bits);
  };
  const planner::Domain& d = space.domain;
  Box box;
  // Twice the centre, so that nothing is halved: 61 bits.
  box.t = {Ball(d.low.x) + Ball(d.size.x) * fraction(2 * e.low[0] + e.size[0], 61),
           Ball(d.low.y) + Ball(d.size.y) * fraction(2 * e.low[1] + e.size[1], 61)};
  box.g1 = {Ball(d.size.x) * fraction(e.size[0], 61), Ball()};
  box.g2 = {Ball(), Ball(d.size.y) * fraction(e.size[1], 61)};
  if (space.rotation) {
    box.rotation =
        sine_cosine_of_turns((2 * e.low[2] + e.size[2]) & ((std::uint64_t{1} << 61U) - 1));
    box.h = pi() * fraction(e.size[2], 60);
    box.half = sine_cosine_of_turns(e.size[2]);
  } else {
    box.rotation = meant_rotation(space.fixed_theta);
    box.half = {Ball(), Ball(1.0)};
  }
  return box;
}

Box point_of(const pdg::Frame& frame, const pdg::Vec2 t, const double theta) {
  Box box;
  box.t = framed(frame, t);
  box.rotation = meant_rotation(theta);
  box.half = {Ball(), Ball(1.0)};
  return box;
}

Way way_of(const pdg::Frame& frame, const planner::Configuration& from,
           const planner::Configuration& to) {
  const Vector start = framed(frame, {from.x, from.y});
  return {start, framed(frame, {to.x, to.y}) - start, meant_angle(from.theta),
          meant_angle(to.theta) - meant_angle(from.theta)};
}

Ball sinusoid_least(const Sinusoid& f, const Box& box) {
  return -sinusoid_largest({-f.v, -f.w}, box);
}

Ball sinusoid_largest(const Sinusoid& f, const Box& box) {
  if (!plainly_outside(f.v, f.w, box)) {
    const Ball size = square_root(f.v * f.v + f.w * f.w);
    if (possibly_within(f.v, f.w, size, box)) return size;
  }
  return f.v * box.half.cosine + absolute(f.w) * box.half.sine;
}

namespace {

// What all vertices contribute, turning apart; and the steps from each to the next.
struct Terms {
  std::vector<Sinusoid> all, steps;
};

Terms towards(const Vector& axis, const Piece& a, const Box& box, const bool with_steps) {
  Terms out;
  for (const Vector& p : a.vertices) out.all.push_back(in_terms_of(axis, rotated(box.rotation, p)));
  if (!with_steps) return out;
  for (const Vector& p : a.along) out.steps.push_back(in_terms_of(axis, rotated(box.rotation, p)));
  return out;
}

Ball extent(const Vector& n, const Box& box) {
  return absolute(dot(n, box.g1)) + absolute(dot(n, box.g2));
}

bool zero(const Vector& g) {
  return g.x.middle == 0 && g.y.middle == 0;
}

// R(delta) M . (b - t) is linear in t, so its extremes over the parallelogram are at corners.
template <class Of>
Ball over_corners(const Piece& b, const Vector& normal, const Box& box, const Of& of) {
  const std::size_t count_1 = zero(box.g1) ? 1 : 2;
  const std::size_t count_2 = zero(box.g2) ? 1 : 2;
  Ball out;
  std::vector<Sinusoid> all(b.vertices.size());
  for (std::size_t i = 0; i < count_1 * count_2; ++i) {
    const Vector t = box.t + Ball(i % count_1 == 0 ? -1.0 : 1.0) * box.g1 +
                     Ball(i / count_1 == 0 ? -1.0 : 1.0) * box.g2;
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = in_terms_of(normal, b.vertices[k] - t);
    out = i == 0 ? of(out, all, true) : of(out, all, false);
  }
  return out;
}

Ball robot_edge_offset(const Piece& a, const std::size_t edge) {
  return dot(a.normals[edge], a.vertices[edge]);
}

}  // namespace

Ball wall_least(const Piece& a, const Wall& wall, const Box& box) {
  return envelope_least(towards(wall.normal, a, box, false).all, box) + dot(wall.normal, box.t) -
         wall.offset - extent(wall.normal, box);
}

Ball wall_largest(const Piece& a, const Wall& wall, const Box& box) {
  const Terms terms = towards(wall.normal, a, box, true);
  return envelope_largest(terms.all, terms.steps, box) + dot(wall.normal, box.t) - wall.offset +
         extent(wall.normal, box);
}

std::vector<Axis> axes_of(const Piece& a, const Piece& b) {
  std::vector<Axis> axes;
  for (std::size_t k = 0; k < b.vertices.size(); ++k)
    axes.push_back({pdg::EdgeOwner::kObstacle, k});
  for (std::size_t k = 0; k < a.vertices.size(); ++k) axes.push_back({pdg::EdgeOwner::kRobot, k});
  return axes;
}

Ball least_value(const Piece& a, const Piece& b, const Axis& axis, const Box& box) {
  if (axis.owner == pdg::EdgeOwner::kObstacle) {
    const Vector& n = b.normals[axis.edge];
    return wall_least(a, {n, dot(n, b.vertices[axis.edge])}, box);
  }
  const Vector n = rotated(box.rotation, a.normals[axis.edge]);
  const auto of = [&](const Ball& before, const std::vector<Sinusoid>& all, const bool first) {
    const Ball here = envelope_least(all, box);
    return first ? here : least(before, here);
  };
  return over_corners(b, n, box, of) - robot_edge_offset(a, axis.edge);
}

Ball largest_value(const Piece& a, const Piece& b, const Axis& axis, const Box& box) {
  if (axis.owner == pdg::EdgeOwner::kObstacle) {
    const Vector& n = b.normals[axis.edge];
    return wall_largest(a, {n, dot(n, b.vertices[axis.edge])}, box);
  }
  const Vector n = rotated(box.rotation, a.normals[axis.edge]);
  std::vector<Sinusoid> steps;
  for (const Vector& p : b.along) steps.push_back(in_terms_of(n, p));
  const auto of = [&](const Ball& before, const std::vector<Sinusoid>& all, const bool first) {
    const Ball here = envelope_largest(all, steps, box);
    return first ? here : greatest(before, here);
  };
  return over_corners(b, n, box, of) - robot_edge_offset(a, axis.edge);
}

bool apart(const Piece& a, const Piece& b, const Box& box) {
  for (const Axis& axis : axes_of(a, b))
    if (least_value(a, b, axis, box).certainly_not_negative()) return true;
  return false;
}

bool overlap(const Piece& a, const Piece& b, const Box& box) {
  for (const Axis& axis : axes_of(a, b))
    if (!largest_value(a, b, axis, box).certainly_negative()) return false;
  return true;
}

Ball least_depth(const Piece& a, const Piece& b, const Box& box) {
  const std::vector<Axis> axes = axes_of(a, b);
  Ball largest = largest_value(a, b, axes[0], box);
  for (const Axis& axis : axes) largest = greatest(largest, largest_value(a, b, axis, box));
  return -largest;
}

Ball reach(const Piece& a) {
  Ball out;
  for (const Vector& p : a.vertices) out = greatest(out, length(p));
  return out;
}

Vector low_corner(const Piece& a) {
  Vector out = a.vertices[0];
  for (const Vector& p : a.vertices) out = {least(out.x, p.x), least(out.y, p.y)};
  return out;
}

Vector high_corner(const Piece& a) {
  Vector out = a.vertices[0];
  for (const Vector& p : a.vertices) out = {greatest(out.x, p.x), greatest(out.y, p.y)};
  return out;
}

Ball circle_distance(const Piece& a, const Piece& b, const Box& box) {
  const auto circle = [](const Piece& p) {
    const Vector centre = kHalf * (low_corner(p) + high_corner(p));
    Ball radius;
    for (const Vector& v : p.vertices) radius = greatest(radius, length(v - centre));
    return std::pair{centre, radius};
  };
  const auto [a_centre, a_radius] = circle(a);
  const auto [b_centre, b_radius] = circle(b);
  const Vector d = box.t + rotated(box.rotation, a_centre) - b_centre;
  const Ball dx = greatest(absolute(d.x) - absolute(box.g1.x) - absolute(box.g2.x), Ball());
  const Ball dy = greatest(absolute(d.y) - absolute(box.g1.y) - absolute(box.g2.y), Ball());
  return square_root(dx * dx + dy * dy) - length(a_centre) * box.h - a_radius - b_radius;
}

Ball box_distance(const Ball& robot_reach, const Vector& low, const Vector& high, const Box& box) {
  const auto beyond = [](const Ball& lo, const Ball& hi, const Ball& t, const Ball& width) {
    return greatest(greatest(lo - t, t - hi) - width, Ball());
  };
  const Ball dx = beyond(low.x, high.x, box.t.x, absolute(box.g1.x) + absolute(box.g2.x));
  const Ball dy = beyond(low.y, high.y, box.t.y, absolute(box.g1.y) + absolute(box.g2.y));
  return square_root(dx * dx + dy * dy) - robot_reach;
}

}  // namespace exact
