#include "taut_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "tuning.hpp"

namespace planner {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

constexpr std::array<LatticePoint, 8> kCompass = {
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

double distance(const LatticePoint a, const LatticePoint b) {
  const auto x = static_cast<double>(a.x - b.x);
  const auto y = static_cast<double>(a.y - b.y);
  return std::sqrt(x * x + y * y);
}

// The doubles round a corner: itself if it is one.
void append_doubles(std::vector<LatticePoint>& out, const LatticePoint p) {
  const LatticePoint low{double_below(p.x), double_below(p.y)};
  const LatticePoint high{double_above(p.x), double_above(p.y)};
  out.push_back(low);
  if (low.x != high.x) out.push_back({high.x, low.y});
  if (low.y != high.y) out.push_back({low.x, high.y});
  if (low.x != high.x && low.y != high.y) out.push_back(high);
}

// Start and goal first; then the corners inside the domain in lexicographic order, free or not.
std::vector<LatticePoint> corners_of(const Layer& layer) {
  std::vector<LatticePoint> corners;
  for (const OpenSum& sum : layer.sums)
    for (const LatticePoint p : sum.vertices) append_doubles(corners, p);
  for (const LatticePolygon& piece : layer.region)
    corners.insert(corners.end(), piece.begin(), piece.end());
  std::erase_if(corners, [&](const LatticePoint p) { return !contains(layer.domain, p); });
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  corners.insert(corners.begin(), {layer.start, layer.goal});
  return corners;
}

// Which corners are free, found when it is first asked.
class FreeCorners {
 public:
  FreeCorners(const Layer& layer, const std::vector<LatticePoint>& corners)
      : layer_(layer), corners_(corners), known_(corners.size(), Known::kNothing) {}

  bool operator()(const std::size_t i) {
    if (known_[i] == Known::kNothing)
      known_[i] = is_free(layer_, corners_[i], scratch_) ? Known::kFree : Known::kCovered;
    return known_[i] == Known::kFree;
  }

 private:
  enum class Known : std::uint8_t { kNothing, kFree, kCovered };

  const Layer& layer_;
  const std::vector<LatticePoint>& corners_;
  std::vector<Known> known_;
  std::vector<std::int32_t> scratch_;
};

// Square buckets over points, about one point each.
class Buckets {
 public:
  explicit Buckets(const std::vector<LatticePoint>& points) : points_(points) {
    low_ = high_ = points.front();
    for (const LatticePoint p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    const double area = std::max(1.0, static_cast<double>(high_.x - low_.x)) *
                        std::max(1.0, static_cast<double>(high_.y - low_.y));
    const double side = std::sqrt(area / static_cast<double>(points.size()));
    const double longest =
        static_cast<double>(std::max(high_.x - low_.x, high_.y - low_.y)) / kMostColumns;
    size_ = static_cast<Int64>(std::max({1.0, side, longest})) + 1;
    columns_ = (high_.x - low_.x) / size_ + 1;
    rows_ = (high_.y - low_.y) / size_ + 1;
    buckets_.resize(static_cast<std::size_t>(columns_ * rows_));
    for (std::size_t i = 0; i < points.size(); ++i)
      buckets_[bucket(column(points[i]), row(points[i]))].push_back(i);
  }

  // The `count` points nearest to points[i] that are free, nearer ones first, ties by index; i is
  // not among them.
  std::vector<std::size_t> nearest(const std::size_t i, const std::size_t count,
                                   FreeCorners& is_free) const {
    std::vector<std::pair<double, std::size_t>> found;
    const LatticePoint p = points_[i];
    const Int64 rings = std::max(columns_, rows_);
    for (Int64 ring = 0; ring <= rings; ++ring) {
      visit_ring(column(p), row(p), ring, [&](const std::size_t k) {
        if (k != i && is_free(k)) found.emplace_back(distance(p, points_[k]), k);
      });
      if (found.size() < count) continue;
      // Points outside the rings are farther than `ring` buckets.
      const double reached = static_cast<double>(ring) * static_cast<double>(size_);
      const auto inside = std::count_if(found.begin(), found.end(),
                                        [&](const auto& f) { return f.first <= reached; });
      if (static_cast<std::size_t>(inside) >= count) break;
    }
    std::sort(found.begin(), found.end());
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < std::min(count, found.size()); ++k) out.push_back(found[k].second);
    return out;
  }

 private:
  static constexpr double kMostColumns = 4096.0;

  [[nodiscard]] Int64 column(const LatticePoint p) const { return (p.x - low_.x) / size_; }
  [[nodiscard]] Int64 row(const LatticePoint p) const { return (p.y - low_.y) / size_; }
  [[nodiscard]] std::size_t bucket(const Int64 c, const Int64 r) const {
    return static_cast<std::size_t>(r * columns_ + c);
  }

  template <class Visit>
  void visit_ring(const Int64 c, const Int64 r, const Int64 ring, const Visit& visit) const {
    for (Int64 y = std::max<Int64>(0, r - ring); y <= std::min(rows_ - 1, r + ring); ++y) {
      const bool whole_row = y == r - ring || y == r + ring;
      const Int64 step = whole_row || ring == 0 ? 1 : 2 * ring;
      for (Int64 x = c - ring; x <= c + ring; x += step) {
        if (x < 0 || x >= columns_) continue;
        for (const std::size_t k : buckets_[bucket(x, y)]) visit(k);
      }
    }
  }

  const std::vector<LatticePoint>& points_;
  LatticePoint low_, high_;
  Int64 size_ = 1;
  Int64 columns_ = 1;
  Int64 rows_ = 1;
  std::vector<std::vector<std::size_t>> buckets_;
};

// A* from corner 0 along segments between each corner and its nearest ones: to corner 1, or without
// an aim to the first corner that `arrives` accepts.
class Search {
 public:
  Search(const Layer& layer, const std::vector<LatticePoint>& corners, const Buckets& buckets)
      : layer_(layer), corners_(corners), buckets_(buckets), is_free_corner_(layer, corners) {}

  // Empty: no way with so many neighbours, or too much work.
  std::vector<std::size_t> find(const std::size_t neighbours) {
    return find(neighbours, [](const std::size_t corner) { return corner == 1; }, true);
  }

  std::vector<std::size_t> find(const std::size_t neighbours,
                                const std::function<bool(std::size_t)>& arrives, const bool aimed) {
    std::vector<std::size_t> before(corners_.size(), kNone);
    std::vector<bool> closed(corners_.size(), false);
    std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
    open.push({0.0, 0.0, 0, kNone});
    while (!open.empty() && !exhausted()) {
      const Step step = open.top();
      const std::size_t here = step.to;
      open.pop();
      // Segments are tested as late as possible: most are never needed.
      if (closed[here] || (step.from != kNone && !sees(step.from, here))) continue;
      closed[here] = true;
      before[here] = step.from;
      if (arrives(here)) return way_to(before, here);
      for (const std::size_t next : buckets_.nearest(here, neighbours, is_free_corner_)) {
        if (closed[next]) continue;
        const double cost = step.cost + distance(corners_[here], corners_[next]);
        const double rest = aimed ? distance(corners_[next], corners_[1]) : 0.0;
        open.push({cost + rest, cost, next, here});
      }
    }
    return {};
  }

  [[nodiscard]] bool exhausted() const { return tests_ >= kMostSegmentTests; }

  bool sees(const std::size_t a, const std::size_t b) {
    ++tests_;
    return is_free(layer_, corners_[a], corners_[b], scratch_);
  }

 private:
  static std::vector<std::size_t> way_to(const std::vector<std::size_t>& before,
                                         const std::size_t end) {
    std::vector<std::size_t> way;
    for (std::size_t at = end; at != kNone; at = before[at]) way.push_back(at);
    std::reverse(way.begin(), way.end());
    return way;
  }

  // To a corner from one that is reached: the length so far, and with what is left at least.
  struct Step {
    double bound, cost;
    std::size_t to, from;
    friend auto operator<=>(const Step&, const Step&) = default;
  };

  const Layer& layer_;
  const std::vector<LatticePoint>& corners_;
  const Buckets& buckets_;
  FreeCorners is_free_corner_;
  std::uint64_t tests_ = 0;
  std::vector<std::int32_t> scratch_;
};

// Leaves out corners that both neighbours on the way see past, until none is left.
void shorten(Search& search, std::vector<std::size_t>& way) {
  for (std::size_t i = 1; i + 1 < way.size();) {
    if (!search.sees(way[i - 1], way[i + 1])) {
      ++i;
      continue;
    }
    way.erase(way.begin() + static_cast<std::ptrdiff_t>(i));
    if (i > 1) --i;
  }
}

}  // namespace

std::optional<std::vector<LatticePoint>> find_taut_path(const Layer& layer) {
  if (layer.start == layer.goal) return std::vector{layer.start, layer.goal};
  std::vector<std::int32_t> scratch;
  if (is_free(layer, layer.start, layer.goal, scratch)) return std::vector{layer.start, layer.goal};
  const std::vector<LatticePoint> corners = corners_of(layer);
  const Buckets buckets(corners);
  Search search(layer, corners, buckets);
  for (std::size_t neighbours = kNearestCorners;; neighbours *= kNearestGrowth) {
    std::vector<std::size_t> way = search.find(neighbours);
    if (!way.empty()) {
      shorten(search, way);
      std::vector<LatticePoint> path;
      path.reserve(way.size());
      for (const std::size_t k : way) path.push_back(corners[k]);
      return path;
    }
    if (search.exhausted() || neighbours >= corners.size()) return std::nullopt;
  }
}

std::optional<LatticePoint> free_place_in_region(const Layer& layer) {
  std::vector<std::int32_t> scratch;
  for (const LatticePoint p : corners_of(layer))
    if (in_region(layer, p) && is_free(layer, p, scratch)) return p;
  return std::nullopt;
}

std::optional<std::vector<LatticePoint>> find_way_into_region(const Layer& layer) {
  const std::vector<LatticePoint> corners = corners_of(layer);
  const Buckets buckets(corners);
  Search search(layer, corners, buckets);
  std::vector<std::int32_t> scratch;
  LatticePoint place;
  const auto arrives = [&](const std::size_t corner) {
    const LatticePoint p = corners[corner];
    place = p;
    if (in_region(layer, p)) return true;
    for (const LatticePolygon& piece : layer.region)
      for (const LatticePoint v : piece)
        for (const LatticePoint q : {LatticePoint{v.x, p.y}, LatticePoint{p.x, v.y}}) {
          if (!in_region(layer, q) || !contains(layer.domain, q) || !is_free(layer, p, q, scratch))
            continue;
          place = q;
          return true;
        }
    return false;
  };
  for (std::size_t neighbours = kNearestCorners;; neighbours *= kNearestGrowth) {
    std::vector<std::size_t> way = search.find(neighbours, arrives, false);
    if (!way.empty()) {
      shorten(search, way);
      std::vector<LatticePoint> path;
      for (const std::size_t k : way) path.push_back(corners[k]);
      if (path.back() != place || path.size() == 1) path.push_back(place);
      return path;
    }
    if (search.exhausted() || neighbours >= corners.size()) return std::nullopt;
  }
}

std::optional<std::vector<LatticePoint>> find_way_out(const Layer& layer,
                                                      const std::span<const Int64> lengths,
                                                      const OpenTest& is_open) {
  const std::vector<LatticePoint> corners = corners_of(layer);
  const Buckets buckets(corners);
  Search search(layer, corners, buckets);
  std::vector<std::int32_t> scratch;
  LatticePoint open;
  std::size_t tried = 0;
  const auto leads_out = [&](const LatticePoint from, const LatticePoint to) {
    if (!contains(layer.domain, to) || !is_free(layer, from, to, scratch) || !is_open(to))
      return false;
    open = to;
    return true;
  };
  const auto arrives = [&](const std::size_t corner) {
    if (++tried > kWayOutCorners) return false;
    const LatticePoint p = corners[corner];
    for (const Int64 by : lengths)
      for (const LatticePoint way : kCompass)
        if (leads_out(p, {p.x + by * way.x, p.y + by * way.y})) return true;
    return false;
  };
  const std::vector<std::size_t> way = search.find(kNearestCorners, arrives, false);
  if (way.empty()) return std::nullopt;
  std::vector<LatticePoint> path;
  path.reserve(way.size() + 1);
  for (const std::size_t k : way) path.push_back(corners[k]);
  path.push_back(open);
  return path;
}

}  // namespace planner
