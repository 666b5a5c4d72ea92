// f is convex and least at the origin, so outside the obstacle it is least at the origin or on the
// edge of a polygon, and on that edge at its minimum or at the nearest end, to either side, of the
// stretch that others cover round it.
#include "minkowski_slice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Part of a line.
struct Stretch {
  double low = -kInfinity;
  double high = kInfinity;
};

class Search {
 public:
  Search(const ObstacleSlice& slice, const FarthestPoint& f, const double cutoff,
         const SliceUse use)
      : slice_(slice),
        f_(f),
        use_(use),
        slack_((use == SliceUse::kBound ? 3.0 : 0.5) * slice.error),
        overlap_(3.0 * slice.error),
        bound_(cutoff) {}

  std::optional<SliceMinimum> run(const bool origin_is_covered) {
    if (f_.radius >= bound_) return std::nullopt;
    if (!origin_is_covered && !is_covered({})) return SliceMinimum{{}, f_.radius, -1};
    reach_ = f_.reach(bound_);
    sort_polygons();
    collect_edges();
    while (!edges_.empty() && edges_.front().distance < reach_) {
      search_edge(edges_.front());
      std::pop_heap(edges_.begin(), edges_.end(), later);
      edges_.pop_back();
    }
    return best_;
  }

 private:
  struct Edge {
    double distance = 0.0;  // of its line from the origin
    std::int32_t polygon = 0;
    std::uint32_t plane = 0;
  };

  static bool later(const Edge& a, const Edge& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.plane > b.plane;
  }

  // Large ones cover most.
  void sort_polygons() {
    std::vector<double> areas;
    for (const ObstacleSlice::Polygon& polygon : slice_.polygons) {
      const Vec2 size = polygon.box.high - polygon.box.low;
      areas.push_back(size.x * size.y);
    }
    by_size_.resize(areas.size());
    std::iota(by_size_.begin(), by_size_.end(), std::size_t{0});
    std::sort(by_size_.begin(), by_size_.end(), [&](const std::size_t a, const std::size_t b) {
      return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
    });
  }

  void collect_edges() {
    for (std::size_t k = 0; k < slice_.polygons.size(); ++k) {
      const ObstacleSlice::Polygon& polygon = slice_.polygons[k];
      for (std::uint32_t p = polygon.begin; p < polygon.end; ++p) {
        const double distance = std::abs(slice_.planes[p].offset);
        if (distance < reach_) edges_.push_back({distance, static_cast<std::int32_t>(k), p});
      }
    }
    std::make_heap(edges_.begin(), edges_.end(), later);
  }

  // The stretch of an edge's line that the edge itself takes up, within reach. A little more does
  // no harm: it is not inside the polygon either. Without it two edges that coincide but for
  // rounding, of either body, could each cut off the other.
  Stretch extent(const Edge& edge, const Line& line) const {
    const double half = std::sqrt((reach_ - edge.distance) * (reach_ + edge.distance));
    Stretch on{-half, half};
    const ObstacleSlice::Polygon& polygon = slice_.polygons[static_cast<std::size_t>(edge.polygon)];
    for (std::uint32_t p = polygon.begin; p < polygon.end; ++p) {
      if (p == edge.plane) continue;
      const SlicePlane& plane = slice_.planes[p];
      const double rate = dot(plane.normal, line.along);
      const double rest = plane.offset + overlap_ - dot(plane.normal, line.foot);
      // Divides only where that shortens the stretch.
      if (rate > 0.0 && rest < on.high * rate) on.high = rest / rate;
      if (rate < 0.0 && rest < on.low * rate) on.low = rest / rate;
      if (on.low > on.high) return on;
    }
    return on;
  }

  bool is_covered(const Vec2 t) const {
    return std::any_of(slice_.polygons.begin(), slice_.polygons.end(), [&](const auto& polygon) {
      return in_box(polygon.box, t) &&
             std::all_of(slice_.planes.begin() + polygon.begin, slice_.planes.begin() + polygon.end,
                         [&](const SlicePlane& plane) {
                           return dot(plane.normal, t) < plane.offset - slack_;
                         });
    });
  }

  static bool in_box(const Box& box, const Vec2 t) {
    return t.x > box.low.x && t.x < box.high.x && t.y > box.low.y && t.y < box.high.y;
  }

  // Where the line leaves the polygon, from s on in one direction, if the polygon covers s.
  std::optional<double> exit(const ObstacleSlice::Polygon& polygon, const Line& line,
                             const double s, const double direction) const {
    double exit = kInfinity;  // times the direction
    for (std::uint32_t p = polygon.begin; p < polygon.end; ++p) {
      const SlicePlane& plane = slice_.planes[p];
      const double rate = dot(plane.normal, line.along);
      const double whole = plane.offset - dot(plane.normal, line.foot);
      const double rest = whole - slack_;
      if (!(rate * s < rest)) return std::nullopt;
      const double end = use_ == SliceUse::kValue ? whole : rest;
      const double ahead = direction * rate;
      if (ahead > 0.0 && end < exit * ahead) exit = end / ahead;
    }
    return direction * exit;
  }

  // The first point that no polygon covers, from s on in one direction (+1 or -1) up to `end`.
  std::optional<double> first_free(const Line& line, double s, const double end,
                                   const double direction) {
    for (bool moved = true; moved;) {
      moved = false;
      const Vec2 t = point_at(line, s);
      for (const std::size_t k : by_size_) {
        const ObstacleSlice::Polygon& polygon = slice_.polygons[k];
        if (!in_box(polygon.box, t)) continue;
        const std::optional<double> left = exit(polygon, line, s, direction);
        // At its end, up to rounding, it does not cover s.
        if (!left || !(direction * *left > direction * s)) continue;
        s = *left;
        if (!(direction * s <= direction * end)) return std::nullopt;
        moved = true;
        break;
      }
    }
    return s;
  }

  // Most edges are covered from end to end, which is cheaper to see than where f is least.
  void search_edge(const Edge& edge) {
    const SlicePlane& plane = slice_.planes[edge.plane];
    const Line line{plane.offset * plane.normal, perp(plane.normal)};
    const Stretch on = extent(edge, line);
    if (!(on.low <= on.high)) return;
    const double nearest = std::clamp(0.0, on.low, on.high);
    if (std::hypot(edge.distance, nearest) >= reach_) return;
    std::optional<double> above = first_free(line, nearest, on.high, 1.0);
    std::optional<double> below = first_free(line, nearest, on.low, -1.0);
    if (!above && !below) return;
    const double least = f_.least_on(line, on.low, on.high);
    if (f_.value(point_at(line, least)) >= bound_) return;
    if (least < below.value_or(on.low) || least > above.value_or(on.high)) {
      above = first_free(line, least, on.high, 1.0);
      below = first_free(line, least, on.low, -1.0);
    }
    if (above) offer(edge, point_at(line, *above));
    if (below) offer(edge, point_at(line, *below));
  }

  void offer(const Edge& edge, const Vec2 t) {
    const double value = f_.value(t);
    if (value >= bound_) return;
    bound_ = value;
    reach_ = f_.reach(bound_);
    best_ = SliceMinimum{t, value, edge.polygon};
  }

  const ObstacleSlice& slice_;
  const FarthestPoint& f_;
  SliceUse use_;
  double slack_;    // how deep inside every half-plane a point must lie to count as covered
  double overlap_;  // by how much edges are prolonged
  double bound_;
  double reach_ = 0.0;
  std::vector<std::size_t> by_size_;  // polygons, those with the largest boxes first
  std::vector<Edge> edges_;
  std::optional<SliceMinimum> best_;
};

}  // namespace

void add_difference(const SlicePiece& a, const SlicePiece& b, ObstacleSlice& slice) {
  ObstacleSlice::Polygon polygon;
  polygon.box = difference_box(a.box, b.box);
  polygon.begin = static_cast<std::uint32_t>(slice.planes.size());
  // n . (b - a) is greatest, over b, on B's edge with normal n, and over a where n . a is least.
  for (std::size_t k = 0; k < b.normals.size(); ++k) {
    const Vec2 n = b.normals[k];
    slice.planes.push_back({n, dot(n, b.vertices[k]) - least_along(n, a.vertices)});
  }
  for (std::size_t k = 0; k < a.normals.size(); ++k) {
    const Vec2 m = a.normals[k];
    slice.planes.push_back({-m, dot(m, a.vertices[k]) - least_along(m, b.vertices)});
  }
  polygon.end = static_cast<std::uint32_t>(slice.planes.size());
  slice.polygons.push_back(polygon);
}

std::optional<SliceMinimum> least_outside(const ObstacleSlice& slice, const FarthestPoint& f,
                                          const double cutoff, const SliceUse use,
                                          const bool origin_is_covered) {
  return Search(slice, f, cutoff, use).run(origin_is_covered);
}

}  // namespace pdg
