#include "convex_separators.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "pdg/native/geometry/box_tree.hpp"
#include "pdg/native/pieces/decompose.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

double value(const HalfPlane& side, const Vec2 p) {
  return dot(side.normal, p) - side.offset;
}

HalfPlane reversed(const HalfPlane& side) {
  return {-side.normal, -side.offset};
}

// What a container is made from. Areas are compared within the frame only.
struct Maker {
  const PieceSet& body;
  ConvexPolygon frame;
  double error = 0.0;  // of value() for points of the frame
};

struct Container {
  std::vector<HalfPlane> sides;
  ConvexPolygon region;  // within the frame
};

ConvexPolygon clipped(const ConvexPolygon& region, const HalfPlane& side) {
  ConvexPolygon inside;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const Vec2 p = region[k];
    const Vec2 q = region[k + 1 == region.size() ? 0 : k + 1];
    const double at_p = value(side, p);
    const double at_q = value(side, q);
    if (at_p <= 0.0) inside.push_back(p);
    if ((at_p < 0.0 && at_q > 0.0) || (at_p > 0.0 && at_q < 0.0)) {
      inside.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
  }
  return inside;
}

double area(const ConvexPolygon& region) {
  double twice = 0.0;
  for (std::size_t k = 2; k < region.size(); ++k) {
    twice += cross(region[k - 1] - region[0], region[k] - region[0]);
  }
  return 0.5 * twice;
}

template <class Points>
double least_value(const HalfPlane& side, const Points& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 p : points) least = std::min(least, value(side, p));
  return least;
}

// Lines along edges of either polygon that have the seed inside and the piece beyond.
std::vector<HalfPlane> separating_sides(const ConvexPiece& seed, const ConvexPolygon& seed_vertices,
                                        const ConvexPiece& piece,
                                        const ConvexPolygon& piece_vertices, const double error) {
  std::vector<HalfPlane> sides;
  for (const Edge& edge : piece.edges) {
    const HalfPlane outer{edge.normal, edge.offset};
    if (least_value(outer, seed_vertices) >= -error) sides.push_back(reversed(outer));
  }
  for (const Edge& edge : seed.edges) {
    const HalfPlane side{edge.normal, edge.offset};
    if (least_value(side, piece_vertices) >= -error) sides.push_back(side);
  }
  return sides;
}

bool is_beyond(const ConvexPolygon& piece, const Container& container, const double error) {
  return std::any_of(container.sides.begin(), container.sides.end(),
                     [&](const HalfPlane& side) { return least_value(side, piece) >= -error; });
}

// The body's pieces, those nearest to the seed first.
std::vector<std::size_t> by_distance(const PieceSet& body, const ConvexPiece& seed) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t j = 0; j < body.pieces.size(); ++j) {
    double separation = -std::numeric_limits<double>::infinity();
    for (const Edge& edge : seed.edges) {
      separation = std::max(separation, least_value({edge.normal, edge.offset}, body.polygons[j]));
    }
    order.emplace_back(separation, j);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> indices;
  indices.reserve(order.size());
  for (const auto& [separation, j] : order) indices.push_back(j);
  return indices;
}

// Nothing if some piece of the body overlaps the seed.
std::optional<Container> grown(const Maker& maker, const ConvexPolygon& seed_vertices) {
  const ConvexPiece seed = make_piece(seed_vertices, Frame{});
  Container container{{}, maker.frame};
  for (const std::size_t j : by_distance(maker.body, seed)) {
    const ConvexPolygon& piece = maker.body.polygons[j];
    if (is_beyond(piece, container, maker.error)) continue;
    double most = -1.0;
    std::pair<HalfPlane, ConvexPolygon> best;
    for (const HalfPlane& side :
         separating_sides(seed, seed_vertices, maker.body.pieces[j], piece, maker.error)) {
      ConvexPolygon region = clipped(container.region, side);
      const double room = area(region);
      if (room <= most) continue;
      most = room;
      best = {side, std::move(region)};
    }
    if (most < 0.0) return std::nullopt;
    container.sides.push_back(best.first);
    container.region = std::move(best.second);
  }
  return container;
}

// Sides that later ones made redundant within the frame, which holds the body, are taken out.
void drop_redundant_sides(Container& container, const double error) {
  std::erase_if(container.sides, [&](const HalfPlane& side) {
    return std::all_of(container.region.begin(), container.region.end(),
                       [&](const Vec2 p) { return value(side, p) < -error; });
  });
}

// Whether a line separates the container from the body's hull: taking the hulls apart does better.
bool is_outside_hull(const Maker& maker, const Container& container) {
  const auto separates = [&](const HalfPlane& line, const ConvexPolygon& other) {
    return least_value(line, other) >= -maker.error;
  };
  const ConvexPolygon& hull = maker.body.hull;
  const ConvexPiece piece = make_piece(hull, Frame{});
  return std::any_of(piece.edges.begin(), piece.edges.end(),
                     [&](const Edge& edge) {
                       return separates({edge.normal, edge.offset}, container.region);
                     }) ||
         std::any_of(container.sides.begin(), container.sides.end(),
                     [&](const HalfPlane& side) { return separates(side, hull); });
}

bool is_inside(const Container& inner, const Container& outer, const double error) {
  return std::all_of(outer.sides.begin(), outer.sides.end(), [&](const HalfPlane& side) {
    return std::all_of(inner.region.begin(), inner.region.end(),
                       [&](const Vec2 p) { return value(side, p) <= error; });
  });
}

// Convex pieces of the frame less the polygons (even-odd); none where the polygons cross.
std::vector<ConvexPolygon> complement(const ConvexPolygon& frame,
                                      const std::vector<Polygon>& polygons) {
  Polygon outside{{frame}};
  for (const Polygon& polygon : polygons) {
    outside.rings.insert(outside.rings.end(), polygon.rings.begin(), polygon.rings.end());
  }
  try {
    return convex_pieces(outside);
  } catch (const std::invalid_argument&) {
    return {};
  }
}

std::vector<ConvexPolygon> seeds(const Maker& maker) {
  const std::vector<Polygon>& polygons = maker.body.outline;
  std::vector<ConvexPolygon> found = complement(maker.frame, polygons);
  if (!found.empty()) return found;
  for (const Polygon& polygon : polygons) {
    for (ConvexPolygon& seed : complement(maker.frame, {polygon})) found.push_back(std::move(seed));
  }
  return found;
}

// The body's box, grown on every side by its longer side.
ConvexPolygon frame_of(const Box& box) {
  const double width = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const Vec2 low = box.low - Vec2{width, width};
  const Vec2 high = box.high + Vec2{width, width};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

}  // namespace

std::vector<ConvexSeparator> convex_separators(const PieceSet& body) {
  if (body.hull.size() < 3) return {};
  Maker maker{body, frame_of(bounding_box(body.hull)), 0.0};
  double reach = 0.0;
  for (const Vec2 corner : maker.frame) reach = std::max(reach, norm(corner));
  maker.error = kSeparationErrorUnits * kUnitRoundoff * reach;
  std::vector<Container> kept;
  for (const ConvexPolygon& seed : seeds(maker)) {
    std::optional<Container> container = grown(maker, seed);
    if (!container) continue;
    drop_redundant_sides(*container, maker.error);
    if (is_outside_hull(maker, *container)) continue;
    const auto inside = [&](const Container& inner, const Container& outer) {
      return is_inside(inner, outer, maker.error);
    };
    if (std::any_of(kept.begin(), kept.end(),
                    [&](const Container& other) { return inside(*container, other); })) {
      continue;
    }
    std::erase_if(kept, [&](const Container& other) { return inside(other, *container); });
    kept.push_back(*std::move(container));
  }
  std::vector<ConvexSeparator> separators;
  separators.reserve(kept.size());
  for (Container& container : kept) separators.push_back({std::move(container.sides), maker.error});
  return separators;
}

}  // namespace pdg
