#include "nonconvex_depth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generalized_depth.hpp"
#include "pdg/native/geometry/convex_hull.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "pdg/native/slices/minkowski_slice.hpp"
#include "pdg/native/slices/slice_pieces.hpp"
#include "pdg/native/tolerances.hpp"
#include "placed_outline.hpp"
#include "polygon_distance.hpp"

namespace pdg {
namespace {

double box_distance(const Box& a, const Box& b) {
  return std::hypot(std::max({0.0, a.low.x - b.high.x, b.low.x - a.high.x}),
                    std::max({0.0, a.low.y - b.high.y, b.low.y - a.high.y}));
}

// No pair overlaps: the nearest pair, or the first that touches.
TranslationalDepth nearest_pair(const std::vector<ConvexPolygon>& a, const PieceSet& b) {
  TranslationalDepth nearest;
  nearest.depth = -std::numeric_limits<double>::infinity();
  for (const ConvexPolygon& piece : a) {
    const Box box = bounding_box(piece);
    for (const ConvexPolygon& other : b.polygons) {
      // Rounded distances of boxes may exceed those of what is in them by a few roundings.
      if (box_distance(box, bounding_box(other)) > -nearest.depth * kRadiusPadding) continue;
      const TranslationalDepth pair = translational_depth(piece, other);
      if (std::pair{pair.state, pair.depth} > std::pair{nearest.state, nearest.depth}) {
        nearest = pair;
      }
    }
  }
  return nearest;
}

// Where two polygons touch: a vertex of one lies on an edge of the other, up to rounding.
Vec2 contact(const ConvexPolygon& a, const ConvexPolygon& b) {
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [vertices, edges] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (const Vec2 w : *vertices) {
      for (std::size_t k = 0; k < edges->size(); ++k) {
        const Vec2 foot = closest_on_segment(w, (*edges)[k], (*edges)[(k + 1) % edges->size()]);
        const double distance = std::hypot(w.x - foot.x, w.y - foot.y);
        if (distance >= least) continue;
        least = distance;
        nearest = vertices == &b ? w : foot;
      }
    }
  }
  return nearest;
}

// The least translation out of the overlap.
TranslationalDepth way_out(const std::vector<ConvexPolygon>& a, const PieceSet& b) {
  // Leaving the hull leaves the body: a bound of the depth.
  const TranslationalDepth out_of_hulls = translational_depth(convex_hull(a), b.hull);
  const Vec2 origin = a.front().front();
  const SlicePieces moving = shifted_pieces(a, origin);
  const SlicePieces fixed = shifted_pieces(b.polygons, origin);
  ObstacleSlice slice;
  const FarthestPoint length;
  const double error =
      kSliceErrorUnits * kUnitRoundoff * (moving.reach + fixed.reach + out_of_hulls.depth);
  const double cutoff = out_of_hulls.depth * kRadiusPadding + 8.0 * error;
  add_near_differences(moving, fixed, length.reach(cutoff), 0.0, slice);
  const std::optional<SliceMinimum> least =
      least_outside(slice, length, cutoff, SliceUse::kValue, true);
  if (!least) throw std::logic_error("no way out of the hulls' overlap");
  TranslationalDepth result;
  result.state = PairState::kOverlap;
  result.depth = least->value;
  result.direction = least->value > 0.0 ? (1.0 / least->value) * least->t : out_of_hulls.direction;
  // Where the two pieces meet then.
  const ObstacleSlice::Polygon& polygon = slice.polygons[static_cast<std::size_t>(least->polygon)];
  ConvexPolygon moved = a[static_cast<std::size_t>(polygon.piece_a)];
  for (Vec2& v : moved) v = v + least->t;
  result.on_b = contact(moved, b.polygons[static_cast<std::size_t>(polygon.piece_b)]);
  result.on_a = result.on_b - result.depth * result.direction;
  return result;
}

}  // namespace

TranslationalDepth translational_depth(const PieceSet& a, const PieceSet& b, const Pose& pose) {
  if (a.polygons.size() == 1 && b.polygons.size() == 1) {
    PlacedOutline moved;
    return translational_depth(a.polygons[0], pose, make_outline(b.polygons[0]), moved);
  }
  std::vector<ConvexPolygon> moved;
  moved.reserve(a.polygons.size());
  for (const ConvexPolygon& polygon : a.polygons) {
    moved.push_back(placed(polygon, pose));
    if (!std::all_of(moved.back().begin(), moved.back().end(), in_exact_range)) {
      throw std::invalid_argument("coordinate outside the range of exact arithmetic");
    }
    restore_convexity(moved.back());
  }
  DepthScratch scratch;
  return interiors_are_disjoint(a, b, pose, scratch) ? nearest_pair(moved, b) : way_out(moved, b);
}

}  // namespace pdg
