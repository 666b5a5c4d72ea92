#include "generalized_depth.hpp"

#include <algorithm>

#include "placed_outline.hpp"

namespace pdg {
namespace {

using Candidate = DepthScratch::Candidate;

void take_piece(const PlacedBody& body, const std::size_t i, ConvexPolygon& piece) {
  const auto vertex = [&](const std::uint32_t k) {
    return body.vertices.begin() + static_cast<std::ptrdiff_t>(k);
  };
  piece.assign(vertex(body.first[i]), vertex(body.first[i + 1]));
  restore_convexity(piece);
}

// All pairs whose depth is within rounding of the greatest one, in order of their indices.
void find_deepest(const PieceSet& a, const PieceSet& b, DepthScratch& scratch) {
  // Twice: the error of the depth compared, and of the one it is compared with.
  const double slack = 2.0 * scratch.placed.error;
  double best = 0.0;
  scratch.candidates.clear();
  NearPairs(
      a.tree, scratch.placed.boxes, b.tree,
      [&](const double depth) { return depth > 0.0 && depth > best - slack; },
      [&](const std::size_t i, const std::size_t j) {
        const double depth = -pair_separation(scratch.placed, i, b.pieces[j], slack - best).value;
        if (depth <= best - slack) return;
        scratch.candidates.push_back({depth, i, j});
        best = std::max(best, depth);
      })
      .run();
  std::erase_if(scratch.candidates, [&](const Candidate& c) { return c.depth <= best - slack; });
  std::sort(scratch.candidates.begin(), scratch.candidates.end(),
            [](const Candidate& c, const Candidate& d) {
              return c.piece_a != d.piece_a ? c.piece_a < d.piece_a : c.piece_b < d.piece_b;
            });
}

}  // namespace

DepthLowerBound generalized_depth_lower_bound(const PieceSet& a, const PieceSet& b,
                                              const Pose& pose, DepthScratch& scratch) {
  place(a, pose, b.radius, scratch.placed);
  find_deepest(a, b, scratch);
  DepthLowerBound best;
  for (const Candidate& candidate : scratch.candidates) {
    // Rounding may leave a depth of 0 between polygons that just overlap.
    const double beaten = best.piece_a >= 0 ? best.depth : -scratch.placed.error;
    take_piece(scratch.placed, candidate.piece_a, scratch.piece);
    const auto pair = overlap_deeper_than(scratch.piece, b.polygons[candidate.piece_b], beaten);
    if (!pair) continue;
    best = {pair->depth, static_cast<int>(candidate.piece_a), static_cast<int>(candidate.piece_b),
            *pair};
  }
  return best;
}

DepthLowerBound generalized_depth_lower_bound(const PieceSet& a, const PieceSet& b,
                                              const Pose& pose) {
  DepthScratch scratch;
  return generalized_depth_lower_bound(a, b, pose, scratch);
}

bool interiors_are_disjoint(const PieceSet& a, const PieceSet& b, const Pose& pose,
                            DepthScratch& scratch) {
  place(a, pose, b.radius, scratch.placed);
  const double error = scratch.placed.error;
  bool disjoint = true;
  NearPairs(
      a.tree, scratch.placed.boxes, b.tree,
      [&](const double depth) { return disjoint && depth > 0.0; },
      [&](const std::size_t i, const std::size_t j) {
        const double separation = pair_separation(scratch.placed, i, b.pieces[j], error).value;
        if (separation >= error) return;
        disjoint = separation > -error;
        if (!disjoint) return;
        // Decided exactly where rounding leaves it open.
        take_piece(scratch.placed, i, scratch.piece);
        disjoint = !overlap_exactly(scratch.piece, b.polygons[j]);
      })
      .run();
  return disjoint;
}

}  // namespace pdg
