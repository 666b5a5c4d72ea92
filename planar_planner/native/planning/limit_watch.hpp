// The clock of a query, and what ends it before its answer: limits and the listener.
#pragma once

#include <functional>
#include <optional>

#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/outcome.hpp"

namespace planner {

// Seconds of a clock that only runs forward.
double steady_seconds();

// Both arguments must outlive it. Its clock begins with it.
class LimitWatch {
 public:
  LimitWatch(const Limits& limits, const Listener& listener)
      : limits_(limits), listener_(listener), begin_(steady_seconds()) {}

  [[nodiscard]] double elapsed() const { return steady_seconds() - begin_; }
  [[nodiscard]] bool out_of_time() const { return elapsed() >= limits_.timeout; }
  // A LimitCheck: why to stop now, if so. Asks for progress only to tell the listener of it.
  std::optional<StopReason> check(const Usage& usage, const std::function<Progress()>& progress);

 private:
  const Limits& limits_;
  const Listener& listener_;
  double begin_;
  double last_call_ = 0.0;  // of the listener, seconds after the beginning
};

}  // namespace planner
