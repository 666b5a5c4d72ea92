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
// Adds the exact segments before and after those that `evidence` has, and the layer's pieces to its
// names; its waypoints are those of the whole path.
void add_exact_segments(const Layer& layer, Evidence& evidence);
Evidence chain_evidence(const Layer& layer, const std::vector<ChainLink>& chain);

}  // namespace planner
