// Facets by the bound that they set, the least first; dead ones are dropped when they come up.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace pdg {

struct QueuedFacet {
  double bound = 0.0;
  std::int32_t facet = 0;
  std::uint32_t generation = 0;
};

class FacetQueue {
 public:
  void push(const QueuedFacet& facet) {
    heap_.push_back(facet);
    std::ranges::push_heap(heap_, later);
  }

  // The facet of the hull with the least bound; it stays in the queue.
  template <class Hull>
  std::optional<QueuedFacet> least(const Hull& hull) {
    while (!heap_.empty()) {
      const QueuedFacet& top = heap_.front();
      if (hull.alive(top.facet) && hull.generation(top.facet) == top.generation) return top;
      drop();
    }
    return std::nullopt;
  }

  // Drops the facet that is least; the queue must not be empty.
  void drop() {
    std::ranges::pop_heap(heap_, later);
    heap_.pop_back();
  }

 private:
  // Ties by id, so that results are the same everywhere.
  static bool later(const QueuedFacet& a, const QueuedFacet& b) {
    return a.bound > b.bound || (a.bound == b.bound && a.facet > b.facet);
  }

  std::vector<QueuedFacet> heap_;
};

}  // namespace pdg
