#include "crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>

namespace planner {

namespace {

// Points of the lattice along each axis; so many fit in some milliseconds of depths.
constexpr int kSide = 13;
// The lattice reaches beyond the box of its ends by this fraction of the box's greatest side.
constexpr double kMargin = 0.4;
// Stretches to replace: each is a few lattice steps long, about a third of the one before.
constexpr int kRounds = 6;
// Ablation into which a leg of a way is cut to look at its depths.
constexpr std::size_t kLegParts = 4;
// Lattice steps to either side of the deepest that the next stretch takes in, at least.
constexpr std::size_t kReach = 2;

using Index = std::array<int, 3>;

class Lattice {
 public:
  Lattice(const Configuration& from, const Configuration& to, const double radius) {
    const std::array<double, 3> a{from.x, from.y, from.theta}, b{to.x, to.y, to.theta};
    const std::array<double, 3> scale{1.0, 1.0, radius};
    double side = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      side = std::max(side, scale.at(k) * std::abs(b.at(k) - a.at(k)));
    for (std::size_t k = 0; k < 3; ++k) {
      low_.at(k) = std::min(a.at(k), b.at(k));
      count_.at(k) = scale.at(k) > 0.0 ? kSide : 1;
      if (count_.at(k) == 1) continue;
      const double margin = kMargin * side / scale.at(k);
      low_.at(k) -= margin;
      step_.at(k) = (std::abs(b.at(k) - a.at(k)) + 2.0 * margin) / (kSide - 1);
    }
  }

  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(count_[0] * count_[1] * count_[2]);
  }
  [[nodiscard]] Index index(const std::uint32_t node) const {
    const int n = static_cast<int>(node);
    return {n % count_[0], n / count_[0] % count_[1], n / (count_[0] * count_[1])};
  }
  [[nodiscard]] std::uint32_t node(const Index& i) const {
    return static_cast<std::uint32_t>(i[0] + count_[0] * (i[1] + count_[1] * i[2]));
  }
  // The corners of the lattice's cell that holds the configuration.
  template <class Visit>
  void visit_corners(const Configuration& q, const Visit& visit) const {
    const std::array<double, 3> at{q.x, q.y, q.theta};
    Index low{};
    Index high{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (count_.at(k) == 1) continue;
      low.at(k) = static_cast<int>((at.at(k) - low_.at(k)) / step_.at(k));
      low.at(k) = std::clamp(low.at(k), 0, count_.at(k) - 2);
      high.at(k) = low.at(k) + 1;
    }
    visit_box(low, high, visit);
  }
  [[nodiscard]] Configuration at(const std::uint32_t node) const {
    const Index i = index(node);
    return {low_[0] + step_[0] * i[0], low_[1] + step_[1] * i[1], low_[2] + step_[2] * i[2]};
  }
  // All that differ by at most one step along each axis, itself included.
  template <class Visit>
  void visit_neighbours(const std::uint32_t node, const Visit& visit) const {
    const Index i = index(node);
    Index low{};
    Index high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low.at(k) = std::max(i.at(k) - 1, 0);
      high.at(k) = std::min(i.at(k) + 1, count_.at(k) - 1);
    }
    visit_box(low, high, visit);
  }

 private:
  template <class Visit>
  void visit_box(const Index& low, const Index& high, const Visit& visit) const {
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) visit(node({x, y, z}));
  }

  std::array<double, 3> low_{}, step_{};
  Index count_{1, 1, 1};
};

struct Open {
  double deepest, sum;  // of the way so far
  std::uint32_t node, before;
  bool looked = false;  // also between the two

  // Lowest first; nodes make the order, and so the way, the same every time.
  bool operator<(const Open& other) const {
    if (deepest != other.deepest) return deepest > other.deepest;
    if (sum != other.sum) return sum > other.sum;
    return node != other.node ? node > other.node : before > other.before;
  }
};

Configuration between(const Configuration& a, const Configuration& b, const double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.theta + s * (b.theta - a.theta)};
}

// The same way with what lies between its configurations.
Crossing with_legs(const Crossing& way, const DepthAt& depth_at) {
  Crossing out;
  for (std::size_t i = 0; i < way.way.size(); ++i) {
    for (std::size_t k = 1; i > 0 && k < kLegParts; ++k) {
      out.way.push_back(between(way.way[i - 1], way.way[i], static_cast<double>(k) / kLegParts));
      out.depth.push_back(depth_at(out.way.back()));
    }
    out.way.push_back(way.way[i]);
    out.depth.push_back(way.depth[i]);
  }
  out.deepest = deepest_of(out.depth);
  return out;
}

// Replaces the values first .. last.
template <class Value>
void splice(std::vector<Value>& values, const std::size_t first, const std::size_t last,
            const std::vector<Value>& by) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  const auto after = values.erase(begin, begin + static_cast<std::ptrdiff_t>(last - first + 1));
  values.insert(after, by.begin(), by.end());
}

// Replaces the stretch first .. last of a way, where its bottleneck is.
void replace(Crossing& crossing, const std::size_t first, const std::size_t last,
             const Crossing& by) {
  splice(crossing.way, first, last, by.way);
  splice(crossing.depth, first, last, by.depth);
  crossing.deepest = first + by.deepest;
}

}  // namespace

double depth_between(const Configuration& a, const Configuration& b, const DepthAt& depth_at) {
  double most = 0.0;
  for (std::size_t k = 1; k < kLegParts; ++k)
    most = std::max(most, depth_at(between(a, b, static_cast<double>(k) / kLegParts)));
  return most;
}

std::size_t deepest_of(const std::vector<double>& depth) {
  return static_cast<std::size_t>(std::max_element(depth.begin(), depth.end()) - depth.begin());
}

Crossing least_overlap(const Configuration& from, const Configuration& to, const double radius,
                       const DepthAt& depth_at) {
  const Lattice lattice(from, to, radius);
  constexpr double kUnknown = -1.0;
  constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<double> depth(lattice.size(), kUnknown);
  std::vector<bool> settled(lattice.size()), last(lattice.size());
  std::vector<std::uint32_t> before(lattice.size(), kNone);
  std::priority_queue<Open> queue;
  const auto reach = [&](const std::uint32_t node, const Open& way) {
    if (settled[node]) return;
    if (depth[node] == kUnknown) depth[node] = depth_at(lattice.at(node));
    queue.push({std::max(way.deepest, depth[node]), way.sum + depth[node], node, way.node});
  };
  lattice.visit_corners(to, [&](const std::uint32_t node) { last[node] = true; });
  lattice.visit_corners(from,
                        [&](const std::uint32_t node) { reach(node, {0.0, 0.0, kNone, kNone}); });
  std::uint32_t end = kNone;
  while (end == kNone) {
    Open open = queue.top();
    queue.pop();
    if (settled[open.node]) continue;
    if (!open.looked) {  // only now, since few legs are ever the best
      const Configuration before_it = open.before == kNone ? from : lattice.at(open.before);
      open.deepest =
          std::max(open.deepest, depth_between(before_it, lattice.at(open.node), depth_at));
      open.looked = true;
      queue.push(open);
      continue;
    }
    settled[open.node] = true;
    before[open.node] = open.before;
    if (last[open.node]) end = open.node;
    lattice.visit_neighbours(open.node, [&](const std::uint32_t next) { reach(next, open); });
  }
  Crossing out{{to}, {depth_at(to)}, 0};
  for (std::uint32_t node = end; node != kNone; node = before[node]) {
    out.way.push_back(lattice.at(node));
    out.depth.push_back(depth[node]);
  }
  out.way.push_back(from);
  out.depth.push_back(depth_at(from));
  std::reverse(out.way.begin(), out.way.end());
  std::reverse(out.depth.begin(), out.depth.end());
  out.deepest = deepest_of(out.depth);
  return out;
}

void sharpen(Crossing& crossing, const double radius, const DepthAt& depth_at) {
  std::size_t first = 0;
  std::size_t last = 0;
  const auto about_deepest = [&](const std::size_t reach) {
    first = crossing.deepest - std::min(crossing.deepest, reach);
    last = std::min(crossing.deepest + reach, crossing.way.size() - 1);
  };
  const auto sample = [&](const std::size_t i) { return depth_at(crossing.way[i]); };
  about_deepest(1);
  Crossing stretch;
  for (std::size_t i = first; i <= last; ++i) {
    stretch.way.push_back(crossing.way[i]);
    stretch.depth.push_back(sample(i));
  }
  replace(crossing, first, last, with_legs(stretch, depth_at));
  about_deepest(0);
  for (int round = 0; round < kRounds; ++round) {
    const double most = crossing.depth[crossing.deepest];
    if (first > 0) --first;
    while (first > 0 && sample(first) >= most) --first;
    const std::size_t end = crossing.way.size() - 1;
    if (last < end) ++last;
    while (last < end && sample(last) >= most) ++last;
    if (first == last) return;
    const Crossing finer = with_legs(
        least_overlap(crossing.way[first], crossing.way[last], radius, depth_at), depth_at);
    if (finer.depth[finer.deepest] > most) continue;
    replace(crossing, first, last, finer);
    about_deepest(kReach * kLegParts);
  }
}

}  // namespace planner
