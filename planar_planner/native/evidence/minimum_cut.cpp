#include "minimum_cut.hpp"

#include <algorithm>

namespace planner {

void MinimumCut::add_arc(const std::uint32_t u, const std::uint32_t v, const std::uint32_t forth,
                         const std::uint32_t back) {
  arcs_.push_back({v, first_[u], forth});
  first_[u] = static_cast<std::uint32_t>(arcs_.size() - 1);
  arcs_.push_back({u, first_[v], back});
  first_[v] = static_cast<std::uint32_t>(arcs_.size() - 1);
}

std::uint64_t MinimumCut::solve(const std::uint32_t source, const std::uint32_t sink) {
  std::uint64_t flow = 0;
  while (flow < kUncuttable && find_levels(source, sink)) {
    current_ = first_;
    while (const std::uint32_t more = augment(source, sink)) flow += more;
  }
  return flow;
}

// Distances from the source along arcs that are not full; without a way to the sink, what they
// reach is the source's side.
bool MinimumCut::find_levels(const std::uint32_t source, const std::uint32_t sink) {
  level_.assign(first_.size(), kNone);
  queue_.assign(1, source);
  level_[source] = 0;
  for (std::size_t head = 0; head < queue_.size(); ++head) {
    const std::uint32_t node = queue_[head];
    for (std::uint32_t k = first_[node]; k != kNone; k = arcs_[k].next) {
      const Arc& arc = arcs_[k];
      if (arc.capacity == 0 || level_[arc.to] != kNone) continue;
      level_[arc.to] = level_[node] + 1;
      queue_.push_back(arc.to);
    }
  }
  return level_[sink] != kNone;
}

// One way to the sink through ever higher levels, depth first, and its flow; 0 if none is left.
std::uint32_t MinimumCut::augment(const std::uint32_t source, const std::uint32_t sink) {
  way_.clear();
  std::uint32_t node = source;
  while (node != sink) {
    std::uint32_t& k = current_[node];
    while (k != kNone && (arcs_[k].capacity == 0 || level_[arcs_[k].to] != level_[node] + 1))
      k = arcs_[k].next;
    if (k != kNone) {
      way_.push_back(k);
      node = arcs_[k].to;
      continue;
    }
    if (way_.empty()) return 0;
    node = arcs_[way_.back() ^ 1U].to;  // a dead end: back, and never here again
    way_.pop_back();
    current_[node] = arcs_[current_[node]].next;
  }
  std::uint32_t flow = kUncuttable;
  for (const std::uint32_t k : way_) flow = std::min(flow, arcs_[k].capacity);
  for (const std::uint32_t k : way_) {
    arcs_[k].capacity -= flow;
    arcs_[k ^ 1U].capacity += flow;
  }
  return flow;
}

}  // namespace planner
