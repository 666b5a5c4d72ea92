// The C-obstacle query: does A meet the interior of B in every configuration of a cell?
#pragma once

#include <cstdint>

#include "pdg/native/geometry/motion_bound.hpp"
#include "pdg/native/pieces/piece_set.hpp"

namespace pdg {

enum class QueryMethod : std::uint8_t {
  kPublished,     // [PDG] 8.1: max PD^t over pairs at the centre > Eq. 3, r of the whole body
  kDisplacement,  // some pair: PD^t at the centre > displacement bound, r of the pair's piece
  kPerNormal,     // some pair: every separating-axis function is negative over the whole cell
};

// All (x, y, theta) within the half-extents of the centre; closed. Half-extents of theta of pi or
// more mean every orientation.
struct Cell {
  Pose centre;
  HalfExtents half;
};

// full: proven that the interiors meet in every configuration of the cell, for the exact doubles
// given (rounding is accounted for). Not full: undecided, never a claim that some part is free.
struct CObstacleVerdict {
  bool full = false;
  int piece_a = -1;  // the witness pair, or the one that came closest; -1 when no boxes meet
  int piece_b = -1;
  // Length, full iff > 0. Certified lower bound of: scalar forms, PD^t at the centre less the
  // motion bound; per normal, PD^t over the whole cell. -infinity when no boxes meet.
  double margin = 0.0;
};

CObstacleVerdict c_obstacle_query(const PieceSet& a, const PieceSet& b, const Cell& cell,
                                  QueryMethod method);

}  // namespace pdg
