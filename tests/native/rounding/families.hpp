// The families of predicates: each evaluates at least the number of inputs asked for, those that
// bracket (brackets, and d_Q of sets) a hundredth of it.
#pragma once

#include <vector>

#include "tally.hpp"

namespace rounding {

std::vector<Tally> pairs(const Request& request);
std::vector<Tally> segments(const Request& request);
std::vector<Tally> bounds(const Request& request);
std::vector<Tally> scenes(const Request& request);
std::vector<Tally> placements(const Request& request);
std::vector<Tally> depths(const Request& request);
std::vector<Tally> queries(const Request& request);
std::vector<Tally> distances(const Request& request);
std::vector<Tally> brackets(const Request& request);
std::vector<Tally> sets(const Request& request);

}  // namespace rounding
