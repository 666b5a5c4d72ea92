#include "generalized_depth.hpp"

#include <algorithm>

namespace pdg {

DepthLowerBound generalized_depth_lower_bound(const PieceSet& a, const PieceSet& b,
                                              const Pose& pose) {
  DepthLowerBound best;
  std::vector<std::int32_t> near;
  for (std::size_t i = 0; i < a.polygons.size(); ++i) {
    const ConvexPolygon moved = placed(a.polygons[i], pose);
    near.clear();
    find_meeting(b.tree, bounding_box(moved), near);
    std::sort(near.begin(), near.end());  // the first of equally deep pairs wins
    for (const std::int32_t j : near) {
      const TranslationalDepth pair =
          translational_depth(moved, b.polygons[static_cast<std::size_t>(j)]);
      if (pair.state != PairState::kOverlap) continue;
      if (best.piece_a >= 0 && pair.depth <= best.depth) continue;
      best = {pair.depth, static_cast<int>(i), j, pair};
    }
  }
  return best;
}

}  // namespace pdg
