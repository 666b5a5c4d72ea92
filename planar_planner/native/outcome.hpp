// What an answer rests on, and why a query stayed undecided. Programs decide on these enumerators;
// the sentences that people read are made in Python (planar_planner/planning/outcome.py).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace planner {

enum class Verdict : std::uint8_t { kPath, kNoPath, kUndecided };

// X(enumerator, name in Python, value in Python and in result files)
#define PLANNER_DECIDED_BY(X)                                                              \
  X(kStraightMove, STRAIGHT_MOVE, "straight move") /* path: one segment */                 \
  X(kTwoLegMove, TWO_LEG_MOVE, "two-leg move")     /* path: a turn and a translation */    \
  X(kDisc, DISC, "disc")                           /* either: a disc as the robot */       \
  X(kFirstTry, FIRST_TRY, "RRT-Connect")           /* path: guessed by random trees */     \
  X(kChannel, CHANNEL, "channel")                  /* path: through solid cells */         \
  X(kRidge, RIDGE, "ridge")                        /* path: guessed through a channel */   \
  X(kTautPath, TAUT_PATH, "taut path")             /* path: exact, along corners */        \
  X(kJoinedLayers, JOINED_LAYERS, "joined layers") /* path: exact parts joined by cells */ \
  X(kSeparation, SEPARATION, "separation")         /* no path: FULL cells and faces */     \
  X(kOddChain, ODD_CHAIN, "odd chain")             /* no path: exact, open sums */         \
  X(kStart, START, "start")                        /* no path: the start is not free */    \
  X(kGoal, GOAL, "goal")                           /* no path: the goal is not free */

// A limit has the name of the option that sets it.
#define PLANNER_STOP_REASON(X)                                                              \
  X(kResolution, RESOLUTION, "resolution")                                                  \
  X(kMaxCells, MAX_CELLS, "max_cells")                                                      \
  X(kMaxMemory, MAX_MEMORY, "max_memory")                                                   \
  X(kTimeout, TIMEOUT, "timeout")                                                           \
  X(kInterrupted, INTERRUPTED, "interrupted")     /* by the listener, or by Ctrl-C */       \
  X(kOutOfMemory, OUT_OF_MEMORY, "out_of_memory") /* an allocation failed */                \
  X(kStartTouchesObstacle, START_TOUCHES_OBSTACLE, "start_touches_obstacle")                \
  X(kStartTouchesWorkspace, START_TOUCHES_WORKSPACE, "start_touches_workspace")             \
  X(kGoalTouchesObstacle, GOAL_TOUCHES_OBSTACLE, "goal_touches_obstacle")                   \
  X(kGoalTouchesWorkspace, GOAL_TOUCHES_WORKSPACE, "goal_touches_workspace")                \
  X(kTightTurn, TIGHT_TURN, "tight_turn")       /* resolution; no way joins exact layers */ \
  X(kNoDoubles, NO_DOUBLES, "no_doubles")       /* a path, but none of doubles found */     \
  X(kMovedEnds, MOVED_ENDS, "moved_ends")       /* no path, but between moved ends */       \
  X(kNoEvidence, NO_EVIDENCE, "no_evidence")    /* a path with room of rounding only */     \
  X(kLostChannel, LOST_CHANNEL, "lost_channel") /* a defect of the search */

#define PLANNER_ENUMERATOR(enumerator, name, word) enumerator,
#define PLANNER_NAME(enumerator, name, word) Name<Enum>{Enum::enumerator, #name, word},

enum class DecidedBy : std::uint8_t { PLANNER_DECIDED_BY(PLANNER_ENUMERATOR) };
enum class StopReason : std::uint8_t { PLANNER_STOP_REASON(PLANNER_ENUMERATOR) };

template <class Enum>
struct Name {
  Enum value;
  const char* python;
  std::string_view word;
};

// All enumerators in order, with their names.
template <class Enum>
struct Names;

template <>
struct Names<DecidedBy> {
  using Enum = DecidedBy;
  static constexpr const char* kClass = "DecidedBy";
  static constexpr auto kAll = std::to_array({PLANNER_DECIDED_BY(PLANNER_NAME)});
};

template <>
struct Names<StopReason> {
  using Enum = StopReason;
  static constexpr const char* kClass = "StopReason";
  static constexpr auto kAll = std::to_array({PLANNER_STOP_REASON(PLANNER_NAME)});
};

#undef PLANNER_NAME
#undef PLANNER_ENUMERATOR

template <class Enum>
constexpr std::string_view word(const Enum value) {
  return Names<Enum>::kAll[static_cast<std::size_t>(value)].word;
}

}  // namespace planner
