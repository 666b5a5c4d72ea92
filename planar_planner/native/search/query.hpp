// One query while it is being answered: its ends, limits and answer so far.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "planar_planner/native/configurations/goal_region.hpp"
#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/outcome.hpp"
#include "planar_planner/native/paths/path.hpp"
#include "planar_planner/native/statistics.hpp"
#include "planar_planner/native/stopwatch.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace planner {

// Translations at a quarter turn that are free exactly: they may touch. The way's waypoints with
// both its ends, and which of the query's layers they are in.
struct ExactLeg {
  std::vector<Configuration> way;
  std::size_t layer = 0;
};

// They lead from the user's start to the one that is planned from, and from the goal that is
// planned to on to the user's.
struct ExactLegs {
  ExactLeg before, after;
  [[nodiscard]] bool empty() const { return before.way.empty() && after.way.empty(); }
};

// The waypoints of a path from `first` to `last` are an exact leg.
struct ExactRun {
  std::size_t first, last;
  std::size_t layer;
};

struct Answer {
  Verdict verdict = Verdict::kUndecided;
  std::optional<StopReason> stop_reason;  // kUndecided
  std::optional<StopReason> stopped_by;   // a limit or the listener, whatever the verdict
  bool ends_moved = false;                // off a contact, within the contact tolerance
  bool to_be_checked = false;             // the evidence's room is within the rounding's bound
  PathReport path;                        // kPath
  std::vector<ExactRun> exact;            // parts of the path, in order
  Statistics statistics;
};

struct Query {
  Configuration start;
  Configuration goal;                  // with a region: the one that the search tries for now
  const GoalRegion* region = nullptr;  // any of its configurations is a goal
  const Limits& limits;
  Clock clock;       // for stopwatches
  LimitCheck check;  // whether a limit is reached, or the listener has had enough
  Answer answer;
  std::optional<StopReason> stopped_by;  // a limit that was reached, or the listener
  ExactLegs legs;                        // of ends in contact, without rounding
  bool lifted = false;                   // an end in contact was moved off
  bool no_doubles = false;  // a path exists exactly, but none was found whose corners are doubles
  std::optional<StopReason> in_contact;  // of an end that was not: a path cannot be certified

  Query(const Configuration& s, const Goal& g, const GoalRegion* r, const Limits& l, Clock seconds,
        LimitCheck stop)
      : start(s), region(r), limits(l), clock(std::move(seconds)), check(std::move(stop)) {
    if (r == nullptr) goal = std::get<Configuration>(g);
  }

  void decide(const Verdict verdict, const DecidedBy by) {
    answer.verdict = verdict;
    answer.stop_reason.reset();
    answer.statistics.decided_by = by;
  }
  void leave_undecided(const StopReason reason) {
    answer.verdict = Verdict::kUndecided;
    answer.stop_reason = reason;
    answer.statistics.decided_by.reset();
  }
};

}  // namespace planner
