#include "robot.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/geometry/convex_hull.hpp"
#include "pieces.hpp"
#include "planar_planner/native/tolerances.hpp"

namespace planner {

namespace {

// Signed distance of the origin to the piece's boundary lines: > 0 outside some edge.
double origin_outside(const pdg::ConvexPiece& piece) {
  double outside = -INFINITY;
  for (const pdg::Edge& edge : piece.edges) outside = std::max(outside, -edge.offset);
  return outside;
}

// Upper bound of the distance of the origin from a convex piece, by its edges' nearest points; 0 if
// it is inside beyond doubt. Near a sharp vertex it can be far out although no edge's line is.
double origin_distance(const pdg::ConvexPiece& piece) {
  const double slack = kHullDistanceUnits * pdg::kUnitRoundoff * piece.reach;
  if (origin_outside(piece) < -slack) return 0.0;
  double nearest = INFINITY;
  for (std::size_t k = 0; k < piece.edges.size(); ++k) {
    const Vec2 a = piece.edges[k].vertex;
    const Vec2 along = piece.edges[(k + 1) % piece.edges.size()].vertex - a;
    const double s = std::clamp(-pdg::dot(a, along) / pdg::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, pdg::norm(a + s * along));
  }
  return nearest + slack;
}

}  // namespace

Robot make_robot(const PolygonSet& polygons, const int exponent, const bool partition) {
  Robot robot;
  const pdg::Frame frame{{}, exponent};
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const Polygon polygon = polygons.polygon(i);
    points.insert(points.end(), polygon.rings[0].begin(), polygon.rings[0].end());
    for (const pdg::ConvexPolygon& piece : planner_pieces(polygon, partition)) {
      robot.pieces.push_back(pdg::make_piece(piece, frame));
      robot.polygon_of_piece.push_back(static_cast<std::uint32_t>(i));
    }
  }
  robot.pieces.push_back(pdg::make_piece(pdg::convex_hull(std::move(points)), frame));
  robot.polygon_of_piece.push_back(0);
  for (const pdg::ConvexPiece& piece : robot.pieces) {
    robot.first_vertex.push_back(static_cast<std::uint32_t>(robot.vertex_total));
    robot.vertex_total += piece.edges.size();
    robot.reach = std::max(robot.reach, piece.reach);
    if (&piece == &robot.pieces.back() || -origin_outside(piece) <= robot.inner_reach) continue;
    robot.inner_reach = -origin_outside(piece);
    robot.inner_piece = static_cast<std::uint16_t>(&piece - robot.pieces.data());
  }
  robot.first_vertex.push_back(static_cast<std::uint32_t>(robot.vertex_total));
  robot.inner_reach =
      std::max(0.0, robot.inner_reach - kInnerReachUnits * pdg::kUnitRoundoff * robot.reach);
  robot.hull_distance = origin_distance(robot.pieces.back());
  return robot;
}

}  // namespace planner
