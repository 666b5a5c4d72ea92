#include "piece_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "pdg/native/geometry/convex_hull.hpp"

namespace pdg {

PieceSet make_piece_set(std::vector<ConvexPolygon> polygons) {
  PieceSet set;
  set.polygons = std::move(polygons);
  std::vector<Box> boxes;
  for (const ConvexPolygon& polygon : set.polygons) {
    // Constraint counts edges in 16 bits; an edge left out would make false claims.
    if (polygon.size() > std::numeric_limits<std::uint16_t>::max()) {
      throw std::invalid_argument("convex piece with more than 65535 vertices");
    }
    set.pieces.push_back(make_piece(polygon, Frame{}));
    set.radii.push_back(set.pieces.back().reach);
    set.radius = std::max(set.radius, set.radii.back());
    boxes.push_back(bounding_box(polygon));
  }
  set.tree = build_box_tree(boxes);
  set.hull = convex_hull(set.polygons);
  if (!set.hull.empty()) set.hull_piece = make_piece(set.hull, Frame{});
  return set;
}

Rotation rotation_of(const double theta) {
  return {std::cos(theta), std::sin(theta)};
}

ConvexPolygon placed(const ConvexPolygon& polygon, const Pose& pose) {
  const Rotation rotation = rotation_of(pose.theta);
  ConvexPolygon result;
  result.reserve(polygon.size());
  for (const Vec2 v : polygon) result.push_back(rotate(rotation, v) + pose.t);
  return result;
}

}  // namespace pdg
