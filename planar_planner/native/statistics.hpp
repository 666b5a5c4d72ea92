// What was and what was not done, for the user and for the regression counts.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "outcome.hpp"

namespace planner {

struct Seconds {
  double preprocessing = 0.0;
  double labelling = 0.0;
  double faces = 0.0;
  double search = 0.0;
  double path = 0.0;
  double probe = 0.0;
  double total = 0.0;
};

struct Statistics {
  std::uint64_t labelled_cells = 0;
  std::uint64_t separation_evaluations = 0;
  std::uint64_t pairs_touched = 0;
  std::uint64_t pairs_total = 0;
  std::uint64_t star_tests = 0;
  std::uint64_t joint_cells = 0;  // FULL by several pairs together
  std::uint64_t faces_tested = 0;
  std::uint64_t segments_tested = 0;
  std::uint64_t probe_checks = 0;  // configurations that the first try asked about
  std::uint64_t ridge_tries = 0;
  std::uint64_t ridge_evaluations = 0;  // separating-axis functions at single configurations
  std::uint64_t search_rounds = 0;
  std::uint64_t search_expansions = 0;
  std::uint64_t search_rebuilds = 0;  // mended trees that overlooked a channel: a defect
  std::uint64_t channel_length = 0;
  std::uint64_t memory_bytes = 0;
  std::uint64_t constraint_bytes = 0;  // of these: the cells' undecided constraints
  Seconds seconds;
  std::optional<DecidedBy> decided_by;  // empty: undecided

  [[nodiscard]] std::uint64_t axis_work() const {
    return separation_evaluations + ridge_evaluations;
  }
  // Counts and times of a query asked on the way.
  Statistics& operator+=(const Statistics& other);
};

// Adds the time of its life to one of the clocks above. Clocks never steer the search.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), begin_(std::chrono::steady_clock::now()) {}
  ~Stopwatch() { total_ += elapsed(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  double& total_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace planner
