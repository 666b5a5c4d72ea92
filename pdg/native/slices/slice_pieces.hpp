// A body's convex pieces in the frame of a slice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "minkowski_slice.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

// The pieces' vertices and normals one after another; piece i owns [first[i], first[i + 1]).
struct SlicePieces {
  std::vector<Vec2> vertices;
  std::vector<Vec2> normals;
  std::vector<std::uint32_t> first{0};
  std::vector<Box> boxes;
  double reach = 0.0;  // max |vertex|

  [[nodiscard]] std::size_t size() const { return boxes.size(); }
  [[nodiscard]] SlicePiece piece(std::size_t i) const;
};

// vertex - origin, normals from the vertices as given.
SlicePieces shifted_pieces(const std::vector<ConvexPolygon>& polygons, Vec2 origin);

// vertex - origin and the set's normals, before turning.
SlicePieces shifted_pieces(const PieceSet& body, Vec2 origin);

// The same turned about 0, into `turned`, whose memory is used again.
void turn_pieces(const SlicePieces& pieces, const Rotation& rotation, SlicePieces& turned);

// Adds B_j + (-A_i) for every pair that comes within `reach` of the origin; sets slice.error for
// translations within that reach and coordinates that carry `input_error_reach` more magnitude from
// the rounding of their frame.
void add_near_differences(const SlicePieces& a, const SlicePieces& b, double reach,
                          double input_error_reach, ObstacleSlice& slice);

}  // namespace pdg
