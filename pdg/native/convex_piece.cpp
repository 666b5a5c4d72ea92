#include "convex_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tolerances.hpp"

namespace pdg {

namespace {

// Outward unit normal of the directed edge a -> b of a counter-clockwise ring. Scaled by a power
// of two first, so that tiny and huge edges neither underflow nor overflow.
Vec2 outward_normal(const Vec2 a, const Vec2 b, const int exponent) {
  Vec2 along{std::ldexp(b.x, exponent) - std::ldexp(a.x, exponent),
             std::ldexp(b.y, exponent) - std::ldexp(a.y, exponent)};
  const int shift = -std::ilogb(std::max(std::abs(along.x), std::abs(along.y)));
  along = {std::ldexp(along.x, shift), std::ldexp(along.y, shift)};
  const double length = norm(along);
  return {along.y / length, -along.x / length};
}

}  // namespace

Vec2 to_frame(const Frame& frame, const Vec2 point) {
  const int e = frame.exponent;
  return {std::ldexp(point.x, e) - std::ldexp(frame.origin.x, e),
          std::ldexp(point.y, e) - std::ldexp(frame.origin.y, e)};
}

ConvexPiece make_piece(const ConvexPolygon& polygon, const Frame& frame) {
  ConvexPiece piece;
  const std::size_t n = polygon.size();
  piece.edges.resize(n);
  piece.vertex_count = static_cast<int>(n);
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high = -low;
  for (std::size_t k = 0; k < n; ++k) {
    Edge& edge = piece.edges[k];
    edge.vertex = to_frame(frame, polygon[k]);
    edge.normal = outward_normal(polygon[k], polygon[(k + 1) % n], frame.exponent);
    edge.offset = dot(edge.normal, edge.vertex);
    low = {std::min(low.x, edge.vertex.x), std::min(low.y, edge.vertex.y)};
    high = {std::max(high.x, edge.vertex.x), std::max(high.y, edge.vertex.y)};
    piece.reach = std::max(piece.reach, norm(edge.vertex) * kRadiusPadding);
  }
  for (const Edge& edge : piece.edges) piece.inner_centre = piece.inner_centre + edge.vertex;
  piece.inner_centre = (1.0 / static_cast<double>(n)) * piece.inner_centre;
  piece.inner_radius = std::numeric_limits<double>::infinity();
  for (const Edge& edge : piece.edges)
    piece.inner_radius =
        std::min(piece.inner_radius, edge.offset - dot(edge.normal, piece.inner_centre));
  piece.inner_radius =
      std::max(0.0, piece.inner_radius - kSeparationErrorUnits * kUnitRoundoff * piece.reach);
  piece.centre = {0.5 * low.x + 0.5 * high.x, 0.5 * low.y + 0.5 * high.y};
  for (const Edge& edge : piece.edges)
    piece.radius = std::max(piece.radius, norm(edge.vertex - piece.centre));
  // The vertices' own rounding (u reach) counts towards the radius.
  piece.radius = (piece.radius + kVertexUnits * kUnitRoundoff * piece.reach) * kRadiusPadding;
  return piece;
}

ConvexPiece make_half_plane(const Vec2 normal, const double offset) {
  ConvexPiece piece;
  piece.edges.push_back({Vec2{}, normal, offset});
  piece.radius = std::numeric_limits<double>::infinity();
  piece.reach = std::abs(offset);
  return piece;
}

}  // namespace pdg
