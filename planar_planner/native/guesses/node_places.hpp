// Where the nodes of a random tree are: the nearest to a configuration, so that a tree of thousands
// of nodes is not walked for every sample, and how many boxes they lie in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "planar_planner/native/world/problem.hpp"
#include "tuning.hpp"

namespace planner {

// A k-d tree of translations. Numbers what is added from 0. Not balanced: nodes of random trees
// come in random order. To split by theta as well was tried: as many nodes are passed, and each
// takes half as long again.
class NearestByPlace {
 public:
  void add(const Vec2 place) {
    const auto index = static_cast<std::uint32_t>(items_.size());
    items_.push_back({place, {kNone, kNone}});
    if (index == 0) return;
    std::uint32_t at = 0;
    for (bool by_x = true;; by_x = !by_x) {
      std::uint32_t& next = items_[at].below[side(items_[at].place, place, by_x)];
      if (next == kNone) {
        next = index;
        return;
      }
      at = next;
    }
  }

  // The one with the least squared_distance(index), among equal ones always the same; that distance
  // is never less than the squared distance of the places. `passed` counts items asked.
  template <class SquaredDistance>
  std::uint32_t nearest(const Vec2 place, const SquaredDistance& squared_distance,
                        std::uint64_t& passed) {
    std::uint32_t best = 0;
    double least = INFINITY;
    const auto ask = [&](const std::uint32_t i, const Vec2 way) {
      ++passed;
      if (dot(way, way) >= least) return;  // most are too far away without their turn
      const double there = squared_distance(i);
      if (there < least) least = there, best = i;
    };
    if (items_.size() <= kFewItems) {
      for (std::uint32_t i = 0; i < items_.size(); ++i) ask(i, place - items_[i].place);
      return best;
    }
    open_.assign(1, {0, true, 0.0});
    while (!open_.empty()) {
      const Open open = open_.back();
      open_.pop_back();
      if (open.least >= least) continue;
      const Item& item = items_[open.item];
      const Vec2 way = place - item.place;
      ask(open.item, way);
      const double across = open.by_x ? way.x : way.y;
      const std::size_t near = side(item.place, place, open.by_x);
      if (const std::uint32_t far = item.below[1 - near]; far != kNone)
        open_.push_back({far, !open.by_x, std::max(open.least, across * across)});
      if (const std::uint32_t next = item.below[near]; next != kNone)
        open_.push_back({next, !open.by_x, open.least});
    }
    return best;
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  struct Item {
    Vec2 place;
    std::array<std::uint32_t, 2> below;  // the lesser side, the other one
  };
  struct Open {
    std::uint32_t item;
    bool by_x;
    double least;  // squared distance of anything below from the place asked about, or less
  };
  static std::size_t side(const Vec2 of, const Vec2 place, const bool by_x) {
    return (by_x ? place.x >= of.x : place.y >= of.y) ? 1 : 0;
  }

  std::vector<Item> items_;
  std::vector<Open> open_;  // of one search
};

// A growing set of 64-bit numbers, by open addressing: no allocation for each.
class BoxSet {
 public:
  void insert(const std::uint64_t number) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    std::uint64_t& slot = slot_of(number);
    if (slot != kFree) return;
    slot = number;
    ++size_;
  }
  void clear() {
    slots_.clear();
    size_ = 0;
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  static constexpr std::uint64_t kFree = UINT64_MAX;  // no number of a box

  std::uint64_t& slot_of(const std::uint64_t number) {
    // Fibonacci hashing; the number of slots is a power of two.
    std::size_t at = (number * 0x9e3779b97f4a7c15U) >> 32U;
    for (;; ++at) {
      std::uint64_t& slot = slots_[at & (slots_.size() - 1)];
      if (slot == kFree || slot == number) return slot;
    }
  }
  void grow() {
    const std::vector<std::uint64_t> old = std::exchange(
        slots_, std::vector<std::uint64_t>(slots_.empty() ? 64 : 2 * slots_.size(), kFree));
    for (const std::uint64_t number : old)
      if (number != kFree) slot_of(number) = number;
  }

  std::vector<std::uint64_t> slots_;
  std::size_t size_ = 0;
};

}  // namespace planner
