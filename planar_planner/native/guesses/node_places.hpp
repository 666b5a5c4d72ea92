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

namespace planner {

// A point of the plane, and one of a circle: in [-half, half], whose ends are the same.
struct RoundPoint {
  Vec2 place;
  double turn = 0.0;
};

// A k-d tree of places. Numbers what is added from 0. Not balanced: nodes of random trees come in
// random order. To split by the turn as well was tried: as many nodes are passed.
class NearestPoint {
 public:
  void add(const RoundPoint& point) {
    const auto index = static_cast<std::uint32_t>(items_.size());
    items_.push_back({point, {kNone, kNone}});
    if (index == 0) return;
    std::uint32_t at = 0;
    for (bool by_x = true;; by_x = !by_x) {
      const Vec2 way = point.place - items_[at].point.place;
      std::uint32_t& next = items_[at].below[side(by_x ? way.x : way.y)];
      if (next == kNone) {
        next = index;
        return;
      }
      at = next;
    }
  }

  [[nodiscard]] std::size_t bytes() const { return items_.capacity() * sizeof(Item); }

  // By Euclid's distance, the circle's turn the shorter way round; among equally near ones always
  // the same. `passed` counts those asked. There is at least one.
  std::uint32_t nearest(const RoundPoint& point, const double half, std::uint64_t& passed) {
    std::uint32_t best = 0;
    double least = INFINITY;
    open_.clear();
    for (Open next{0, true, 0.0};;) {
      // Down on the side of the point; the other sides wait.
      std::uint32_t at = next.item;
      const double bound = next.least;
      for (bool by_x = next.by_x; at != kNone; by_x = !by_x) {
        ++passed;
        const Item& item = items_[at];
        const Vec2 way = point.place - item.point.place;
        const double turn = std::abs(point.turn - item.point.turn);
        const double round = std::min(turn, 2.0 * half - turn);
        const double there = dot(way, way) + round * round;
        if (there < least) least = there, best = at;
        const double across = by_x ? way.x : way.y;
        const std::size_t near = side(across);
        const double beyond = std::max(bound, across * across);
        if (const std::uint32_t far = item.below[1 - near]; far != kNone && beyond < least)
          open_.push_back({far, !by_x, beyond});
        at = item.below[near];
      }
      while (!open_.empty() && open_.back().least >= least) open_.pop_back();
      if (open_.empty()) return best;
      next = open_.back();
      open_.pop_back();
    }
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  struct Item {
    RoundPoint point;
    std::array<std::uint32_t, 2> below;  // the lesser side, the other one
  };
  struct Open {
    std::uint32_t item;
    bool by_x;
    double least;  // squared distance of anything below from the point asked about, or less
  };
  static std::size_t side(const double across) { return across >= 0.0 ? 1 : 0; }

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
  [[nodiscard]] std::size_t bytes() const { return slots_.capacity() * sizeof(std::uint64_t); }

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
