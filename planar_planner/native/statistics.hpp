// What was and what was not done, for the user and for the regression counts. Each list below is
// the only one of its fields: it makes the struct, the sum, the Python class with its documentation
// (bindings/statistics.cpp), the table in docs/method.md and the words that determinism hashes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "outcome.hpp"

namespace planner {

using Work = std::uint64_t;   // steps of the method: the same on every machine
using Count = std::uint64_t;  // of what there is in the end
using Bytes = std::uint64_t;  // depends on the compiler
using Real = double;
using Decision = std::optional<DecidedBy>;
// Indexed by Label.
struct LabelCounts {
  std::array<Count, 4> of{};
  bool operator==(const LabelCounts&) const = default;
};
using LevelCounts = std::vector<Count>;  // by the sum of the three axes' levels

// How a field takes up the same field of a query that was asked on the way.
enum class Adding : std::uint8_t { kSum, kMost, kLatest, kOwn };

// X(name, adding, meaning); seconds of wall-clock time.
#define PLANNER_SECONDS(X)                                                                  \
  X(preprocessing, kSum, "Reading the scene into pieces and trees, once for each planner.") \
  X(labelling, kSum, "Splitting cells and labelling the halves.")                           \
  X(faces, kSum, "Testing faces between solid cells.")                                      \
  X(probe, kSum, "Growing the random trees of the first try.")                              \
  X(search, kSum, "Finding channels, and repairing the search after splits.")               \
  X(path, kSum, "Guessing along ridges, and certifying paths.")                             \
  X(total, kOwn, "The whole query with its preprocessing, and what no other clock measures.")

// X(type, name, adding, unit, meaning)
#define PLANNER_STATISTICS(X)                                                                      \
  X(Count, cells, kLatest, "", "Leaves of the subdivision.")                                       \
  X(LabelCounts, cells_by_label, kLatest, "", "Leaves that are `free`, `star`, `full`, `mixed`.")  \
  X(LevelCounts, cells_by_level, kLatest, "",                                                      \
    "Leaves by level: entry k is those after k halvings, all axes together.")                      \
  X(Work, labelled_cells, kSum, "", "Cells labelled in this query, inner ones included.")          \
  X(Work, separation_evaluations, kSum, "",                                                        \
    "Separating-axis functions whose range was computed, for cells, faces and segments.")          \
  X(Work, pairs_touched, kSum, "",                                                                 \
    "Pairs of a robot piece and an obstacle piece that were examined since the planner was made.") \
  X(Work, pairs_total, kSum, "",                                                                   \
    "All such pairs; an obstacle that was never split into pieces counts as one piece.")           \
  X(Work, star_tests, kSum, "", "MIXED cells to which the star test was applied.")                 \
  X(Work, joint_cells, kSum, "", "Cells that are FULL by several pairs together.")                 \
  X(Work, faces_tested, kSum, "", "Shared faces that were labelled.")                              \
  X(Work, segments_tested, kSum, "", "Straight motions whose certification was tried.")            \
  X(Work, probe_checks, kSum, "", "Configurations that the first try checked for collision.")      \
  X(Work, ridge_tries, kSum, "", "Paths guessed along the ridge of the clearance.")                \
  X(Work, ridge_evaluations, kSum, "",                                                             \
    "Separating-axis functions evaluated at single configurations for those paths; they are not "  \
    "in "                                                                                          \
    "`separation_evaluations`.")                                                                   \
  X(Work, search_rounds, kSum, "", "Searches for a channel.")                                      \
  X(Work, search_expansions, kSum, "", "Steps of the search: leaves settled or repaired.")         \
  X(Work, search_rebuilds, kSum, "",                                                               \
    "Times that the repaired trees missed a channel that a flood fill found; a count above 0 is "  \
    "a defect.")                                                                                   \
  X(Work, channel_length, kOwn, "", "Cells of the last channel of the robot itself.")              \
  X(Bytes, memory_bytes, kMost, "bytes",                                                           \
    "Memory of subdivision, constraints, search and random trees.")                                \
  X(Bytes, constraint_bytes, kMost, "bytes", "The constraints' part of `memory_bytes`.")           \
  X(Seconds, seconds, kSum, "seconds", "Times, by what was done.")                                 \
  X(Real, path_length, kOwn, "scene's length", "Length of the reference point's path.")            \
  X(Real, path_turning, kOwn, "radians", "Sum of the absolute changes of theta along the path.")   \
  X(Real, least_clearance, kOwn, "scene's length",                                                 \
    "Certified lower bound of the clearance along the path, infinite if nothing is near; it is "   \
    "computed after the answer, and no clock measures it.")                                        \
  X(Count, waypoints, kOwn, "", "Number of the path's waypoints.")                                 \
  X(Decision, decided_by, kOwn, "",                                                                \
    "What a path or its absence was shown by (`DecidedBy`); None if the query is undecided.")

struct Seconds {
#define PLANNER_FIELD(name, adding, meaning) double name = 0.0;
  PLANNER_SECONDS(PLANNER_FIELD)
#undef PLANNER_FIELD

  bool operator==(const Seconds&) const = default;
  Seconds& operator+=(const Seconds& other);
};

struct Statistics {
#define PLANNER_FIELD(type, name, adding, unit, meaning) type name{};
  PLANNER_STATISTICS(PLANNER_FIELD)  // NOLINT(readability-redundant-member-init)
#undef PLANNER_FIELD

  [[nodiscard]] std::uint64_t axis_work() const {
    return separation_evaluations + ridge_evaluations;
  }
  bool operator==(const Statistics&) const = default;
  // Takes up the statistics of a query that was asked on the way.
  Statistics& operator+=(const Statistics& other);
};

}  // namespace planner
