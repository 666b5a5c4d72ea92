#include "pieces.hpp"

#include <algorithm>

#include "pdg/native/pieces/decompose.hpp"

namespace planner {

namespace {

// Fans from vertex 0; consecutive ones share an edge, so nothing is lost between them.
void append_fans(const pdg::ConvexPolygon& piece, std::vector<pdg::ConvexPolygon>& out) {
  for (std::size_t first = 1; first + 1 < piece.size(); first += kMaxPieceVertices - 2) {
    const std::size_t last = std::min(first + kMaxPieceVertices - 2, piece.size() - 1);
    pdg::ConvexPolygon fan{piece[0]};
    fan.insert(fan.end(), piece.begin() + static_cast<std::ptrdiff_t>(first),
               piece.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    out.push_back(std::move(fan));
  }
}

}  // namespace

std::vector<pdg::ConvexPolygon> planner_pieces(const pdg::Polygon& polygon, const bool partition) {
  std::vector<pdg::ConvexPolygon> pieces;
  for (pdg::ConvexPolygon& piece :
       partition ? pdg::convex_partition(polygon) : pdg::convex_pieces(polygon)) {
    if (piece.size() <= kMaxPieceVertices)
      pieces.push_back(std::move(piece));
    else
      append_fans(piece, pieces);
  }
  return pieces;
}

}  // namespace planner
