#include "statistics.hpp"

#include <algorithm>

namespace planner {

Statistics& Statistics::operator+=(const Statistics& other) {
  labelled_cells += other.labelled_cells;
  separation_evaluations += other.separation_evaluations;
  star_tests += other.star_tests;
  joint_cells += other.joint_cells;
  faces_tested += other.faces_tested;
  segments_tested += other.segments_tested;
  probe_checks += other.probe_checks;
  ridge_tries += other.ridge_tries;
  ridge_evaluations += other.ridge_evaluations;
  search_rounds += other.search_rounds;
  search_expansions += other.search_expansions;
  search_rebuilds += other.search_rebuilds;
  memory_bytes = std::max(memory_bytes, other.memory_bytes);
  seconds.preprocessing += other.seconds.preprocessing;
  seconds.labelling += other.seconds.labelling;
  seconds.faces += other.seconds.faces;
  seconds.search += other.seconds.search;
  seconds.path += other.seconds.path;
  seconds.probe += other.seconds.probe;
  return *this;
}

}  // namespace planner
