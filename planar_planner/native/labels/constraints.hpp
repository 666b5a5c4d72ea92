// What a cell leaves undecided, handed down to its children: pairs of pieces with their active
// separating-axis functions, and nodes of the obstacle tree that are not yet worth opening.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pdg/native/separation/separation.hpp"

namespace planner {

// robot == kNode: `obstacle` is a node of the obstacle tree and `count` is 0. Otherwise `obstacle`
// and `robot` are pieces and `count` constraints belong to the pair; count 0: the pair is closed,
// no separating-axis function of it has been looked at yet.
struct PairHeader {
  std::uint32_t obstacle;
  std::uint16_t robot;
  std::uint16_t count;
};
inline constexpr std::uint16_t kNode = UINT16_MAX;

inline bool closed(const PairHeader& header) {
  return header.count == 0;
}

struct ConstraintList {
  std::vector<PairHeader> pairs;
  std::vector<pdg::Constraint> constraints;  // in the order of the pairs

  void clear() {
    pairs.clear();
    constraints.clear();
  }
};

struct ConstraintView {
  std::span<const PairHeader> pairs;
  std::span<const pdg::Constraint> constraints;
};

inline ConstraintView view(const ConstraintList& list) {
  return {list.pairs, list.constraints};
}

// Lists of all leaves in one place: pairs and constraints of a cell are two runs of 8-byte records.
// Freed runs are reused by size class (powers of two).
class ConstraintStore {
 public:
  struct Handle {
    std::uint32_t pairs_at;
    std::uint32_t pair_count;
    std::uint32_t constraints_at;
    std::uint32_t constraint_count;
  };

  Handle store(const ConstraintList& list);
  void release(Handle& handle);
  // Valid until the next store().
  [[nodiscard]] ConstraintView get(const Handle& handle) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  template <class T>
  struct Pool {
    std::vector<T> items;
    std::vector<std::vector<std::uint32_t>> free;  // by size class

    std::uint32_t store(std::span<const T> run);
    void release(std::uint32_t at, std::uint32_t count);
  };

  Pool<PairHeader> pairs_;
  Pool<pdg::Constraint> constraints_;
};

}  // namespace planner
