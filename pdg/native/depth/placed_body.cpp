#include "placed_body.hpp"

#include <limits>
#include <utility>

#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Box box_of(const std::span<const Vec2> points) {
  Box box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Vec2 p : points) box = joined(box, {p, p});
  return box;
}

// The least of normal . w - offset over vertices, found from vertex `begin` on (the last edge's
// minimiser, which is near this one's); gives up at a value that is no more than `beaten`.
struct Support {
  double separation = kInfinity;
  std::size_t vertex = 0;
};

template <class VertexAt>
Support least_over(const std::size_t count, const VertexAt& vertex_at, const Vec2 normal,
                   const double offset, const std::size_t begin, const double beaten) {
  Support least;
  for (std::size_t step = 0, k = begin; step < count; ++step) {
    const double s = dot(normal, vertex_at(k)) - offset;
    if (s < least.separation) least = {s, k};
    if (s <= beaten) break;
    if (++k == count) k = 0;
  }
  return least;
}

// The edge beyond which a point lies farthest.
template <class LineAt>
std::size_t farthest_edge(const std::size_t count, const Vec2 point, const LineAt& line_at) {
  std::size_t farthest = 0;
  double most = -kInfinity;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [normal, offset] = line_at(k);
    const double s = dot(normal, point) - offset;
    if (s > most) {
      most = s;
      farthest = k;
    }
  }
  return farthest;
}

void make_room(const std::size_t pieces, const std::size_t vertices, PlacedBody& body) {
  body.vertices.resize(vertices);
  body.normals.resize(vertices);
  body.offsets.resize(vertices);
  body.centres.resize(pieces);
  body.first.resize(pieces + 1);
  body.first[0] = 0;
}

void place_piece(const ConvexPiece& piece, const std::size_t i, const Rotation& rotation,
                 const Vec2 t, PlacedBody& body) {
  std::size_t k = body.first[i];
  for (const Edge& edge : piece.edges) {
    const Vec2 vertex = rotate(rotation, edge.vertex) + t;
    const Vec2 normal = rotate(rotation, edge.normal);
    body.vertices[k] = vertex;
    body.normals[k] = normal;
    body.offsets[k] = dot(normal, vertex);
    ++k;
  }
  body.centres[i] = rotate(rotation, piece.centre) + t;
  body.first[i + 1] = static_cast<std::uint32_t>(k);
}

double error_of(const PieceSet& body, const Pose& pose, const double other_radius) {
  return kSeparationErrorUnits * kUnitRoundoff * (body.radius + other_radius + norm(pose.t));
}

}  // namespace

void place_hull(const PieceSet& body, const Pose& pose, const double other_radius,
                PlacedBody& result) {
  make_room(1, body.hull_piece.edges.size(), result);
  place_piece(body.hull_piece, 0, rotation_of(pose.theta), pose.t, result);
  result.error = error_of(body, pose, other_radius);
}

void place(const PieceSet& body, const Pose& pose, const double other_radius, PlacedBody& result) {
  const Rotation rotation = rotation_of(pose.theta);
  std::size_t vertices = 0;
  for (const ConvexPiece& piece : body.pieces) vertices += piece.edges.size();
  make_room(body.pieces.size(), vertices, result);
  for (std::size_t i = 0; i < body.pieces.size(); ++i) {
    place_piece(body.pieces[i], i, rotation, pose.t, result);
  }
  const std::vector<BoxTree::Node>& nodes = body.tree.nodes;
  result.boxes.resize(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;) {  // children before their parents
    if (nodes[n].item >= 0) {
      const auto i = static_cast<std::size_t>(nodes[n].item);
      const std::size_t count = result.first[i + 1] - result.first[i];
      result.boxes[n] = box_of(std::span(result.vertices).subspan(result.first[i], count));
    } else {
      result.boxes[n] = joined(result.boxes[n + 1], result.boxes[nodes[n + 1].after]);
    }
  }
  result.error = error_of(body, pose, other_radius);
}

Separation pair_separation(const PlacedBody& a, const std::size_t i, const ConvexPiece& b,
                           const double enough) {
  const std::size_t begin = a.first[i];
  const std::size_t count_a = a.first[i + 1] - begin;
  const std::size_t count_b = b.edges.size();
  const auto vertex_of_a = [&](const std::size_t k) { return a.vertices[begin + k]; };
  const auto vertex_of_b = [&](const std::size_t k) { return b.edges[k].vertex; };
  Separation separation{-kInfinity, {}};
  // The axes most likely to separate come first: the others are then soon beaten.
  const std::size_t first_b = farthest_edge(count_b, a.centres[i], [&](const std::size_t k) {
    return std::pair{b.edges[k].normal, b.edges[k].offset};
  });
  std::size_t hint = 0;
  for (std::size_t step = 0, k = first_b; step < count_b; ++step) {
    const Edge& edge = b.edges[k];
    const Support s =
        least_over(count_a, vertex_of_a, edge.normal, edge.offset, hint, separation.value);
    hint = s.vertex;
    if (s.separation > separation.value) separation = {s.separation, edge.normal};
    if (separation.value >= enough) return separation;
    if (++k == count_b) k = 0;
  }
  const std::size_t first_a = farthest_edge(count_a, b.centre, [&](const std::size_t k) {
    return std::pair{a.normals[begin + k], a.offsets[begin + k]};
  });
  hint = 0;
  for (std::size_t step = 0, k = first_a; step < count_a; ++step) {
    const Support s = least_over(count_b, vertex_of_b, a.normals[begin + k], a.offsets[begin + k],
                                 hint, separation.value);
    hint = s.vertex;
    if (s.separation > separation.value) {
      separation = {s.separation, -a.normals[begin + k]};
    }
    if (separation.value >= enough) return separation;
    if (++k == count_a) k = 0;
  }
  return separation;
}

}  // namespace pdg
