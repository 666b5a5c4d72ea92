#include "constraints.hpp"

#include <algorithm>
#include <bit>

namespace planner {

namespace {

int size_class(const std::size_t count) {
  return count == 0 ? 0 : static_cast<int>(std::bit_width(count - 1));
}

}  // namespace

template <class T>
std::uint32_t ConstraintStore::Pool<T>::store(const std::span<const T> run) {
  if (run.empty()) return 0;
  const auto bin = static_cast<std::size_t>(size_class(run.size()));
  std::size_t at = items.size();
  if (bin < free.size() && !free[bin].empty()) {
    at = free[bin].back();
    free[bin].pop_back();
  } else {
    const std::size_t size = at + (std::size_t{1} << bin);
    if (size > items.capacity()) items.reserve(size + size / 4);
    items.resize(size);
  }
  std::copy(run.begin(), run.end(), items.begin() + static_cast<std::ptrdiff_t>(at));
  return static_cast<std::uint32_t>(at);
}

template <class T>
void ConstraintStore::Pool<T>::release(const std::uint32_t at, const std::uint32_t count) {
  if (count == 0) return;
  const auto bin = static_cast<std::size_t>(size_class(count));
  if (free.size() <= bin) free.resize(bin + 1);
  free[bin].push_back(at);
}

ConstraintStore::Handle ConstraintStore::store(const ConstraintList& list) {
  return {pairs_.store(list.pairs), static_cast<std::uint32_t>(list.pairs.size()),
          constraints_.store(list.constraints),
          static_cast<std::uint32_t>(list.constraints.size())};
}

void ConstraintStore::release(Handle& handle) {
  pairs_.release(handle.pairs_at, handle.pair_count);
  constraints_.release(handle.constraints_at, handle.constraint_count);
  handle = {};
}

ConstraintView ConstraintStore::get(const Handle& handle) const {
  return {{pairs_.items.data() + handle.pairs_at, handle.pair_count},
          {constraints_.items.data() + handle.constraints_at, handle.constraint_count}};
}

std::size_t ConstraintStore::bytes() const {
  return pairs_.items.capacity() * sizeof(PairHeader) +
         constraints_.items.capacity() * sizeof(pdg::Constraint);
}

}  // namespace planner
