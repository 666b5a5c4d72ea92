// The evidence of an exact decision at one orientation (docs/certificate.md, "path", "odd_chain").
#pragma once

#include "evidence.hpp"
#include "planar_planner/native/layers/layer.hpp"
#include "planar_planner/native/layers/odd_chain.hpp"

namespace planner {

// One separator a segment for every pair whose boxes come near: an edge of either piece, or the
// line of the segment itself. Two convex sets of which one is a segment are apart iff one of these
// separates them.
Evidence path_evidence(const ScaledProblem& problem, const Layer& layer,
                       const std::vector<Configuration>& waypoints);
Evidence chain_evidence(const Layer& layer, const std::vector<ChainLink>& chain);

}  // namespace planner
