#include "convex_clip.hpp"

#include <algorithm>
#include <cmath>

namespace planner {

namespace {

// The part of the polygon on the side where sign * p[axis] <= sign * bound (Sutherland & Hodgman,
// CACM 1974).
pdg::ConvexPolygon clipped_at(const pdg::ConvexPolygon& polygon, double Vec2::* const axis,
                              const double sign, const double bound) {
  pdg::ConvexPolygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 p = polygon[i];
    const Vec2 q = polygon[(i + 1) % polygon.size()];
    const double of_p = sign * (bound - p.*axis);
    const double of_q = sign * (bound - q.*axis);
    if (of_p >= 0.0) out.push_back(p);
    if ((of_p < 0.0) == (of_q < 0.0)) continue;
    Vec2 cut = p + (of_p / (of_p - of_q)) * (q - p);
    cut.*axis = bound;
    out.push_back(cut);
  }
  return out;
}

double twice_area(const Vec2 a, const Vec2 b, const Vec2 c) {
  return cross(b - a, c - a);
}

}  // namespace

Rectangle bounds_of(const pdg::ConvexPolygon& polygon) {
  Rectangle r{polygon[0], polygon[0]};
  for (const Vec2 p : polygon) {
    r.low = {std::min(r.low.x, p.x), std::min(r.low.y, p.y)};
    r.high = {std::max(r.high.x, p.x), std::max(r.high.y, p.y)};
  }
  return r;
}

bool inside_rectangle(const Rectangle& r, const Vec2 p) {
  return r.low.x <= p.x && p.x <= r.high.x && r.low.y <= p.y && p.y <= r.high.y;
}

pdg::ConvexPolygon clipped(const pdg::ConvexPolygon& polygon, const Rectangle& r) {
  pdg::ConvexPolygon out = clipped_at(polygon, &Vec2::x, 1.0, r.high.x);
  out = clipped_at(out, &Vec2::x, -1.0, r.low.x);
  out = clipped_at(out, &Vec2::y, 1.0, r.high.y);
  return clipped_at(out, &Vec2::y, -1.0, r.low.y);
}

double area_of(const pdg::ConvexPolygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += twice_area(polygon[0], polygon[i - 1], polygon[i]);
  return std::max(0.5 * twice, 0.0);
}

Vec2 middle_of(const pdg::ConvexPolygon& polygon) {
  Vec2 sum;
  for (const Vec2 p : polygon) sum = sum + p;
  return (1.0 / static_cast<double>(polygon.size())) * sum;
}

Vec2 nearest_point(const pdg::ConvexPolygon& polygon, const Vec2 p) {
  bool inside = true;
  Vec2 best = polygon[0];
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 way = polygon[(i + 1) % polygon.size()] - a;
    inside = inside && cross(way, p - a) >= 0.0;
    const double square = dot(way, way);
    const double s = square > 0.0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0.0;
    const Vec2 foot = a + s * way;
    if (pdg::norm(p - foot) < pdg::norm(p - best)) best = foot;
  }
  return inside ? p : best;
}

Vec2 point_at(const pdg::ConvexPolygon& polygon, const double u, const double v) {
  double rest = u * 2.0 * area_of(polygon);
  std::size_t i = 2;
  for (; i + 1 < polygon.size(); ++i) {
    const double twice = twice_area(polygon[0], polygon[i - 1], polygon[i]);
    if (rest < twice) break;
    rest -= twice;
  }
  // Uniform in the triangle: along two sides, folded back.
  const double twice = twice_area(polygon[0], polygon[i - 1], polygon[i]);
  double s = twice > 0.0 ? std::clamp(rest / twice, 0.0, 1.0) : 0.5;
  double t = v;
  if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
  return polygon[0] + s * (polygon[i - 1] - polygon[0]) + t * (polygon[i] - polygon[0]);
}

}  // namespace planner
