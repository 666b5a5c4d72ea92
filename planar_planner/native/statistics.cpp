#include "statistics.hpp"

#include <algorithm>

namespace planner {

namespace {

template <Adding adding, class T>
void add(T& total, const T& part) {
  if constexpr (adding == Adding::kSum) total += part;
  if constexpr (adding == Adding::kMost) total = std::max(total, part);
  if constexpr (adding == Adding::kLatest) total = part;
}

}  // namespace

Seconds& Seconds::operator+=(const Seconds& other) {
#define PLANNER_ADD(name, adding, meaning) add<Adding::adding>(name, other.name);
  PLANNER_SECONDS(PLANNER_ADD)
#undef PLANNER_ADD
  return *this;
}

Statistics& Statistics::operator+=(const Statistics& other) {
#define PLANNER_ADD(type, name, adding, unit, meaning) add<Adding::adding>(name, other.name);
  PLANNER_STATISTICS(PLANNER_ADD)
#undef PLANNER_ADD
  return *this;
}

}  // namespace planner
