// One query while it is being answered: its ends, limits and answer so far.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "planar_planner/native/configurations/goal_region.hpp"
#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/path.hpp"
#include "planar_planner/native/statistics.hpp"
#include "planar_planner/native/world/scene.hpp"

namespace planner {

enum class Verdict : std::uint8_t { kPath, kNoPath, kUndecided };

struct Answer {
  Verdict verdict = Verdict::kUndecided;
  std::string reason;
  bool stopped = false;       // by a limit or the listener
  bool out_of_cells = false;  // that limit was the number of cells
  PathReport path;            // kPath
  Statistics statistics;
  std::array<std::uint64_t, 4> cells_by_label{};  // indexed by Label
  std::vector<std::uint64_t> cells_by_level;      // by the sum of the three axes' levels
};

struct Query {
  Configuration start;
  Configuration goal;                  // with a region: the one that the search tries for now
  const GoalRegion* region = nullptr;  // any of its configurations is a goal
  const Limits& limits;
  const Listener& listener;
  Answer answer;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  double last_call = 0.0;  // of the listener, seconds after `begin`
  bool stopped = false;    // a limit was reached
  bool out_of_cells = false;
  bool lifted = false;  // an end in contact was moved off

  Query(const Configuration& s, const Goal& g, const GoalRegion* r, const Limits& l,
        const Listener& ear)
      : start(s), region(r), limits(l), listener(ear) {
    if (r == nullptr) goal = std::get<Configuration>(g);
  }

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  void conclude(const Verdict verdict, std::string reason, std::string decided_by = "") {
    answer.verdict = verdict;
    answer.reason = std::move(reason);
    answer.statistics.decided_by = std::move(decided_by);
  }
};

}  // namespace planner
