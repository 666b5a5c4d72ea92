// Containers that keep their slack small, since a search may hold millions of cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace planner {

// Room for one more, growing by an eighth: at most 12.5 % slack where doubling leaves up to 100 %.
template <class T>
void grow(std::vector<T>& items) {
  constexpr std::size_t kFirst = 64;
  if (items.size() == items.capacity())
    items.reserve(std::max(kFirst, items.size() + items.size() / 8));
}

// A priority queue (largest first by operator<) whose stale entries can be swept out.
template <class T>
class LazyQueue {
 public:
  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] std::size_t bytes() const { return items_.capacity() * sizeof(T); }
  [[nodiscard]] const T& top() const { return items_.front(); }

  void push(const T& item) {
    grow(items_);
    items_.push_back(item);
    std::push_heap(items_.begin(), items_.end());
  }
  void pop() {
    std::pop_heap(items_.begin(), items_.end());
    items_.pop_back();
  }
  // Drops what is no longer wanted, whenever the queue has doubled since the last time: the work
  // stays below that of the pushes.
  template <class Wanted>
  void sweep(const Wanted& wanted) {
    constexpr std::size_t kFirst = 256;
    if (items_.size() < 2 * kept_ + kFirst) return;
    std::erase_if(items_, [&](const T& item) { return !wanted(item); });
    kept_ = items_.size();
    if (items_.capacity() > 2 * kept_ + kFirst) items_.shrink_to_fit();
    std::make_heap(items_.begin(), items_.end());
  }

 private:
  std::size_t kept_ = 0;
  std::vector<T> items_;
};

}  // namespace planner
