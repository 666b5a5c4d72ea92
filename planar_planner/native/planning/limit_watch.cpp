#include "limit_watch.hpp"

#include <chrono>

namespace planner {

namespace {

// The listener is called at most this often.
constexpr double kListenerPeriod = 0.1;  // seconds

}  // namespace

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::optional<StopReason> LimitWatch::check(const Usage& usage,
                                            const std::function<Progress()>& progress) {
  if (usage.cells >= limits_.max_cells) return StopReason::kMaxCells;
  if (usage.memory_bytes >= limits_.max_memory) return StopReason::kMaxMemory;
  const double now = elapsed();
  if (now >= limits_.timeout) return StopReason::kTimeout;
  if (!listener_ || now - last_call_ < kListenerPeriod) return std::nullopt;
  last_call_ = now;
  Progress told = progress();
  told.elapsed = now;
  if (listener_(told)) return std::nullopt;
  return StopReason::kInterrupted;
}

}  // namespace planner
