#include "thinnest_wall.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "planar_planner/native/cells/adjacency.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"

namespace planner {

namespace {

// Places of a way that may turn out to be free when sharpened.
constexpr int kPlaces = 8;

struct Neighbours {
  std::vector<std::size_t> first;  // of each leaf, and the end
  std::vector<CellId> ids;

  explicit Neighbours(const Subdivision& s) : first(s.size() + 1) {
    std::vector<std::pair<CellId, CellId>> pairs;
    visit_adjacent(s, [&](const CellId a, const CellId b) {
      pairs.emplace_back(a, b);
      ++first[a + 1];
      ++first[b + 1];
    });
    for (std::size_t i = 0; i + 1 < first.size(); ++i) first[i + 1] += first[i];
    ids.resize(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (const auto& [a, b] : pairs) {
      ids[next[a]++] = b;
      ids[next[b]++] = a;
    }
  }
  [[nodiscard]] std::span<const CellId> of(const CellId id) const {
    return std::span(ids).subspan(first[id], first[id + 1] - first[id]);
  }
};

// What a way has cost so far: its deepest overlap, then the sum of its overlaps.
struct Cost {
  double deepest = 0.0;
  double sum = 0.0;

  void raise(const double depth) { deepest = std::max(deepest, depth); }
  bool operator<(const Cost& other) const {
    return deepest < other.deepest || (deepest == other.deepest && sum < other.sum);
  }
};

struct Reached {
  Cost cost;
  CellId before = kNoCell;
  Configuration entry;  // middle of the face towards `before`
  double depth = 0.0;   // there
};

struct Open {
  Reached way;
  CellId cell = kNoCell;
  bool looked = false;  // also between the two faces

  // Lowest first; ids make the order, and so the way, the same every time.
  bool operator<(const Open& other) const {
    if (other.way.cost < way.cost) return true;
    if (way.cost < other.way.cost) return false;
    return cell != other.cell ? other.cell < cell : other.way.before < way.before;
  }
};

Configuration middle_of_face(const ScaledProblem& problem, const Subdivision& s, const CellId a,
                             const CellId b) {
  Axis axis = kNoAxis;
  adjacent(s.cell(a).box, s.cell(b).box, axis);
  const Extent face = common_face(s.cell(a).box, s.cell(b).box, axis);
  std::array<std::uint64_t, 3> at{};
  for (Axis k = 0; k < kNoAxis; ++k) at[k] = face.low[k] + face.size[k] / 2;
  const Vec2 p = to_user(problem, position_of(s.space(), at[kX], at[kY]));
  return {p.x, p.y, s.space().rotation ? radians_of_turns(at[kTheta]) : s.space().fixed_theta};
}

// With theta within half a turn of the other's.
Configuration near_turn(Configuration q, const Configuration& other) {
  q.theta = nearest_turn(q.theta, other.theta);
  return q;
}

Crossing follow(const std::vector<Reached>& reached, CellId cell) {
  Crossing out;
  for (; reached[cell].before != kNoCell; cell = reached[cell].before) {
    out.way.push_back(reached[cell].entry);
    out.depth.push_back(reached[cell].depth);
  }
  std::reverse(out.way.begin(), out.way.end());
  std::reverse(out.depth.begin(), out.depth.end());
  out.deepest = deepest_of(out.depth);
  for (std::size_t i = 1; i < out.way.size(); ++i)
    out.way[i] = near_turn(out.way[i], out.way[i - 1]);
  return out;
}

}  // namespace

Crossing find_thinnest_wall(const ScaledProblem& problem, const Subdivision& s,
                            const std::span<const CellId> start, const std::span<const CellId> goal,
                            const DepthAt& depth_at) {
  const Neighbours neighbours(s);
  const double radius = s.space().rotation ? length_to_user(problem, problem.robot.reach) : 0.0;
  const auto full = [&](const CellId id) { return s.cell(id).label == Label::kFull; };
  std::vector<Reached> reached(s.size());  // of settled leaves
  std::vector<bool> settled(s.size()), wanted(s.size());
  // A goal in a FULL leaf is none that could be reached.
  for (const CellId id : goal) wanted[id] = !full(id);
  std::priority_queue<Open> queue;
  for (const CellId id : start) queue.push({{}, id, true});
  while (!queue.empty()) {
    Open open = queue.top();
    queue.pop();
    if (settled[open.cell]) continue;
    if (!open.looked) {  // only now, since few crossings are ever the best
      const CellId before = open.way.before;
      const Configuration entry = near_turn(reached[before].entry, open.way.entry);
      if (full(before)) open.way.cost.raise(depth_between(entry, open.way.entry, depth_at));
      open.looked = true;
      queue.push(open);
      continue;
    }
    settled[open.cell] = true;
    reached[open.cell] = open.way;
    if (wanted[open.cell]) break;
    for (const CellId next : neighbours.of(open.cell)) {
      if (settled[next]) continue;
      const Configuration at = middle_of_face(problem, s, open.cell, next);
      const bool blocked = full(open.cell) || full(next) || !s.linked(open.cell, next);
      Reached way{open.way.cost, open.cell, at, blocked ? depth_at(at) : 0.0};
      way.cost.raise(way.depth);
      way.cost.sum += way.depth;
      queue.push({way, next, false});
    }
  }
  const auto end = std::find_if(goal.begin(), goal.end(), [&](CellId id) { return settled[id]; });
  if (end == goal.end()) return {};
  Crossing out = follow(reached, *end);
  if (out.way.empty()) return {};
  for (int place = 0; place < kPlaces && out.depth[out.deepest] > 0.0; ++place) {
    sharpen(out, radius, depth_at);
    if (out.depth[out.deepest] > 0.0) return out;
    out.deepest = deepest_of(out.depth);  // the way only cut a corner there
  }
  return {};
}

}  // namespace planner
