// Where a search stops: the user's limits, and a listener that may interrupt it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "outcome.hpp"

namespace planner {

// The defaults are those of Python's Options, which explains each limit, and of the command line.
struct Limits {
  // Smallest half-width of a cell, relative to the domain's. Cells grow with no more than the
  // logarithm of its inverse, so it is small: a path round the corner is found down to 1e-10 from
  // critical.
  double resolution = 1e-9;
  std::uint64_t max_cells = 5'000'000;
  double timeout = 60.0;                               // seconds
  std::uint64_t max_memory = std::uint64_t{4} << 30U;  // bytes
  double contact_tolerance = 0.0;                      // user's length unit
};

// What a search takes up.
struct Usage {
  std::uint64_t cells = 0;
  std::uint64_t memory_bytes = 0;
};

struct Progress {
  double elapsed = 0.0;  // seconds
  std::uint64_t cells = 0, free = 0, star = 0, full = 0, mixed = 0;
  std::uint64_t channel_length = 0;
  std::uint64_t rounds = 0;
};

// False stops the search.
using Listener = std::function<bool(const Progress&)>;

// Asked often, everywhere that work can take long; true: stop now.
using Terminator = std::function<bool()>;

// Asked before each step of a search: why it must stop now, if it must. Calls `progress`, which
// knows no time, only if somebody listens.
using LimitCheck = std::function<std::optional<StopReason>(
    const Usage& usage, const std::function<Progress()>& progress)>;

}  // namespace planner
