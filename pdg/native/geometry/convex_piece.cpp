#include "convex_piece.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pdg/native/tolerances.hpp"

namespace pdg {

namespace {

// Squares of such coordinates neither underflow nor overflow, and have room to be added.
constexpr double kLeastSquared = 0x1p-400;
constexpr double kLargestSquared = 0x1p400;

// Outward unit normal of the directed edge a -> b of a counter-clockwise ring. Tiny and huge edges
// are scaled by a power of two first.
Vec2 outward_normal(const Vec2 a, const Vec2 b, const double scale) {
  Vec2 along{b.x * scale - a.x * scale, b.y * scale - a.y * scale};
  const double largest = std::max(std::abs(along.x), std::abs(along.y));
  if (!(largest >= kLeastSquared && largest <= kLargestSquared)) {
    const int shift = -std::ilogb(largest);
    along = {std::ldexp(along.x, shift), std::ldexp(along.y, shift)};
  }
  const double length = norm(along);
  return {along.y / length, -along.x / length};
}

// 2^exponent, of coordinates that predicates.hpp admits always a normal double: multiplying by it
// rounds as ldexp does.
double frame_scale(const Frame& frame) {
  constexpr int kBias = 1023;
  constexpr unsigned kFractionBits = 52;
  return std::bit_cast<double>(static_cast<std::uint64_t>(frame.exponent + kBias) << kFractionBits);
}

}  // namespace

Vec2 to_frame(const Frame& frame, const Vec2 point) {
  const double scale = frame_scale(frame);
  return {point.x * scale - frame.origin.x * scale, point.y * scale - frame.origin.y * scale};
}

ConvexPiece make_piece(const ConvexPolygon& polygon, const Frame& frame) {
  ConvexPiece piece;
  const double scale = frame_scale(frame);
  const std::size_t n = polygon.size();
  piece.edges.resize(n);
  piece.vertex_count = static_cast<int>(n);
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high = -low;
  for (std::size_t k = 0; k < n; ++k) {
    Edge& edge = piece.edges[k];
    edge.vertex = to_frame(frame, polygon[k]);
    edge.normal = outward_normal(polygon[k], polygon[(k + 1) % n], scale);
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
