#include "slice_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

void add_vertex(SlicePieces& pieces, const Vec2 v) {
  pieces.vertices.push_back(v);
  pieces.reach = std::max(pieces.reach, norm(v));
}

// Ends the piece that was being added.
void close_piece(SlicePieces& pieces) {
  const std::size_t begin = pieces.first.back();
  Box box{pieces.vertices[begin], pieces.vertices[begin]};
  for (std::size_t k = begin + 1; k < pieces.vertices.size(); ++k) {
    box = joined(box, {pieces.vertices[k], pieces.vertices[k]});
  }
  pieces.boxes.push_back(box);
  pieces.first.push_back(static_cast<std::uint32_t>(pieces.vertices.size()));
}

// A point has no edge: any direction will do, because its half-plane bounds B_j + (-A_i) too.
Vec2 outward_normal(const Vec2 u, const Vec2 v) {
  if (u == v) return {1.0, 0.0};
  const double length = std::hypot(v.x - u.x, v.y - u.y);
  return {(v.y - u.y) / length, -((v.x - u.x) / length)};
}

}  // namespace

SlicePiece SlicePieces::piece(const std::size_t i) const {
  const std::size_t count = first[i + 1] - first[i];
  return {{vertices.data() + first[i], count}, {normals.data() + first[i], count}, boxes[i]};
}

SlicePieces shifted_pieces(const std::vector<ConvexPolygon>& polygons, const Vec2 origin) {
  SlicePieces pieces;
  for (const ConvexPolygon& polygon : polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      add_vertex(pieces, polygon[k] - origin);
      pieces.normals.push_back(outward_normal(polygon[k], polygon[(k + 1) % polygon.size()]));
    }
    close_piece(pieces);
  }
  return pieces;
}

SlicePieces shifted_pieces(const PieceSet& body, const Vec2 origin) {
  SlicePieces pieces;
  for (std::size_t i = 0; i < body.polygons.size(); ++i) {
    for (std::size_t k = 0; k < body.polygons[i].size(); ++k) {
      add_vertex(pieces, body.polygons[i][k] - origin);
      pieces.normals.push_back(body.pieces[i].edges[k].normal);
    }
    close_piece(pieces);
  }
  return pieces;
}

void turn_pieces(const SlicePieces& pieces, const Rotation& rotation, SlicePieces& turned) {
  turned.vertices.clear();
  turned.normals.clear();
  turned.boxes.clear();
  turned.first.assign(1, 0);
  turned.reach = pieces.reach;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = pieces.first[i]; k < pieces.first[i + 1]; ++k) {
      turned.vertices.push_back(rotate(rotation, pieces.vertices[k]));
      turned.normals.push_back(rotate(rotation, pieces.normals[k]));
    }
    close_piece(turned);
  }
}

void add_near_differences(const SlicePieces& a, const SlicePieces& b, const double reach,
                          const double input_error_reach, ObstacleSlice& slice) {
  const Box disc{{-reach, -reach}, {reach, reach}};
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (!boxes_meet(difference_box(a.boxes[i], b.boxes[j]), disc)) continue;
      add_difference(a.piece(i), b.piece(j), slice);
      slice.polygons.back().piece_a = static_cast<std::int32_t>(i);
      slice.polygons.back().piece_b = static_cast<std::int32_t>(j);
    }
  }
  slice.error = kSliceErrorUnits * kUnitRoundoff * (a.reach + b.reach + reach + input_error_reach);
}

}  // namespace pdg
