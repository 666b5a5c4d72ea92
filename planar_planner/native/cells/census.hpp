// Counts of the leaves, for answers and for who watches a search.
#pragma once

#include "planar_planner/native/search/query.hpp"
#include "subdivision.hpp"

namespace planner {

// Leaves by label and level.
void take_census(const Subdivision& subdivision, Answer& answer);

}  // namespace planner
