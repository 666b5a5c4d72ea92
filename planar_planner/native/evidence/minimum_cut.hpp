// Least cuts of directed graphs with integer capacities: Dinic's algorithm.
#pragma once

#include <cstdint>
#include <vector>

namespace planner {

class MinimumCut {
 public:
  static constexpr std::uint32_t kUncuttable = UINT32_MAX / 4;

  explicit MinimumCut(const std::size_t nodes) : first_(nodes, kNone) {}

  // Capacities from u to v and from v to u.
  void add_arc(std::uint32_t u, std::uint32_t v, std::uint32_t forth, std::uint32_t back);
  // The least capacity that separates the source from the sink; kUncuttable or more: none does.
  std::uint64_t solve(std::uint32_t source, std::uint32_t sink);
  // After solve: is the node on the source's side?
  [[nodiscard]] bool on_source_side(const std::uint32_t node) const {
    return level_[node] != kNone;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  // Arc k and arc k ^ 1 are each other's reverse.
  struct Arc {
    std::uint32_t to;
    std::uint32_t next;
    std::uint32_t capacity;
  };

  bool find_levels(std::uint32_t source, std::uint32_t sink);
  std::uint32_t augment(std::uint32_t source, std::uint32_t sink);

  std::vector<std::uint32_t> first_;
  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> level_, current_, queue_, way_;
};

}  // namespace planner
