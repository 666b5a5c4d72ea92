#include "odd_chain.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <utility>

namespace planner {

namespace {

constexpr std::array kSides = {Side::kLeft, Side::kRight, Side::kBelow, Side::kAbove};

// Forest of sets with the parity of the way to each one's parent.
class ParityForest {
 public:
  explicit ParityForest(const std::size_t count) : parent_(count), parity_(count, 0) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }

  // False if the two were joined already by a way of the other parity.
  bool join(const std::size_t a, const std::size_t b, const bool parity) {
    const auto [root_a, parity_a] = find(a);
    const auto [root_b, parity_b] = find(b);
    if (root_a == root_b) return (parity_a != parity_b) == parity;
    parent_[root_a] = root_b;
    parity_[root_a] = (parity_a != parity_b) != parity ? 1 : 0;
    return true;
  }

 private:
  std::pair<std::size_t, bool> find(std::size_t i) {
    std::size_t root = i;
    bool total = false;
    while (parent_[root] != root) {
      total = total != (parity_[root] != 0);
      root = parent_[root];
    }
    bool rest = total;
    while (parent_[i] != root && i != root) {
      const std::size_t up = std::exchange(parent_[i], root);
      const bool own = std::exchange(parity_[i], rest ? 1 : 0) != 0;
      rest = rest != own;
      i = up;
    }
    return {root, total};
  }

  std::vector<std::size_t> parent_;
  std::vector<char> parity_;  // no bits: they are exchanged
};

struct Link {
  std::size_t to;
  bool odd;
};

// Sums first, then the four sides of the domain.
struct OverlapGraph {
  std::vector<std::vector<Link>> links;
  std::optional<std::size_t> conflict;  // a set on a cycle of odd parity
};

// Does the way through the overlap of a and b cross the upward ray from p? Each set that lies above
// p is taken from its part left of the ray; so the way crosses iff exactly one of the two lies
// above p and they overlap to its right. (If both lie above, the two ways cross alike or not at
// all. If only one does, the overlap does not meet the vertical line through p.)
bool crosses_ray(const OpenSum& a, const OpenSum& b, const LatticePoint p) {
  const bool above_a = slice_at(a, p) == Slice::kAbove;
  const bool above_b = slice_at(b, p) == Slice::kAbove;
  return above_a != above_b && overlap_right_of(a, b, p.x);
}

bool overlaps_side(const LatticeRectangle& domain, const OpenSum& sum, const Side side) {
  switch (side) {
    case Side::kLeft:
      return sum.low.x < domain.low.x;
    case Side::kRight:
      return sum.high.x > domain.high.x;
    case Side::kBelow:
      return sum.low.y < domain.low.y;
    case Side::kAbove:
      return sum.high.y > domain.high.y;
  }
  return false;
}

// The same for a sum and the half-plane beyond a side, of which only the one above lies above p.
bool crosses_ray(const LatticeRectangle& domain, const OpenSum& sum, const Side side,
                 const LatticePoint p) {
  const Slice slice = slice_at(sum, p);
  if ((slice == Slice::kAbove) == (side == Side::kAbove)) return false;
  if (side == Side::kLeft) return false;
  if (side == Side::kRight) return true;
  if (slice == Slice::kNone) return sum.low.x >= p.x;
  // The part beyond the lower or upper side does not meet the vertical line through p, nor does its
  // closure: it lies where one of its corners lies.
  const Int64 level = side == Side::kBelow ? domain.low.y : domain.high.y;
  return std::any_of(sum.vertices.begin(), sum.vertices.end(), [&](const LatticePoint v) {
    return v.x > p.x && (side == Side::kBelow ? v.y < level : v.y > level);
  });
}

bool overlap(const Side a, const Side b) {
  const auto upright = [](const Side s) { return s == Side::kLeft || s == Side::kRight; };
  return upright(a) != upright(b);
}

class Builder {
 public:
  explicit Builder(const Layer& layer) : layer_(layer), forest_(layer.sums.size() + kSides.size()) {
    graph_.links.resize(layer.sums.size() + kSides.size());
  }

  OverlapGraph build() && {
    const std::size_t sums = layer_.sums.size();
    // Half-planes of neighbouring sides overlap far outside the domain. The rays from start and
    // goal cross the way there alike, so that the parities cancel.
    for (std::size_t a = 0; a < kSides.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (overlap(kSides[a], kSides[b])) link(sums + a, sums + b, false);
    for (std::size_t i = 0; i < sums && !graph_.conflict; ++i) link_sum(i);
    return std::move(graph_);
  }

 private:
  void link_sum(const std::size_t i) {
    const OpenSum& sum = layer_.sums[i];
    for (std::size_t s = 0; s < kSides.size(); ++s)
      if (overlaps_side(layer_.domain, sum, kSides[s]))
        link(i, layer_.sums.size() + s,
             crosses_ray(layer_.domain, sum, kSides[s], layer_.start) !=
                 crosses_ray(layer_.domain, sum, kSides[s], layer_.goal));
    find_near(layer_, sum.low, sum.high, near_);
    std::sort(near_.begin(), near_.end());
    for (const std::int32_t k : near_) {
      const auto j = static_cast<std::size_t>(k);
      if (j >= i || !overlap(sum, layer_.sums[j])) continue;
      link(i, j,
           crosses_ray(sum, layer_.sums[j], layer_.start) !=
               crosses_ray(sum, layer_.sums[j], layer_.goal));
    }
  }

  void link(const std::size_t a, const std::size_t b, const bool odd) {
    graph_.links[a].push_back({b, odd});
    graph_.links[b].push_back({a, odd});
    if (!forest_.join(a, b, odd)) graph_.conflict = a;
  }

  const Layer& layer_;
  ParityForest forest_;
  OverlapGraph graph_;
  std::vector<std::int32_t> near_;
};

// The shortest closed way of odd parity from `from`, by breadth in the double cover of the graph.
std::vector<std::size_t> shortest_odd_cycle(const OverlapGraph& graph, const std::size_t from) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> came_from(2 * graph.links.size(), none);
  std::deque<std::size_t> open{2 * from};
  const std::size_t target = 2 * from + 1;
  while (came_from[target] == none && !open.empty()) {
    const std::size_t node = open.front();
    open.pop_front();
    for (const Link& link : graph.links[node / 2]) {
      const std::size_t next = 2 * link.to + ((node % 2 != 0) != link.odd ? 1 : 0);
      if (next == 2 * from || came_from[next] != none) continue;
      came_from[next] = node;
      open.push_back(next);
    }
  }
  std::vector<std::size_t> cycle;
  for (std::size_t node = came_from[target]; node != none; node = came_from[node])
    cycle.push_back(node / 2);
  return cycle;
}

}  // namespace

std::optional<std::vector<ChainLink>> find_odd_chain(const Layer& layer) {
  const OverlapGraph graph = Builder(layer).build();
  if (!graph.conflict) return std::nullopt;
  std::vector<ChainLink> chain;
  for (const std::size_t set : shortest_odd_cycle(graph, *graph.conflict))
    chain.push_back(set < layer.sums.size() ? static_cast<ChainLink>(set)
                                            : link_of(kSides[set - layer.sums.size()]));
  return chain;
}

}  // namespace planner
