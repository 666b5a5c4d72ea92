// The evidence of an exact decision at one orientation (docs/certificate.md, "path", "odd_chain").
#pragma once

#include <span>

#include "evidence.hpp"
#include "planar_planner/native/layers/layer.hpp"
#include "planar_planner/native/layers/odd_chain.hpp"

namespace planner {

// One separator a segment for every pair whose boxes come near: an edge of either piece, or the
// line of the segment itself. Two convex sets of which one is a segment are apart iff one of these
// separates them.
Evidence path_evidence(const ScaledProblem& problem, const Layer& layer,
                       const std::vector<Configuration>& waypoints);
// Proves the segments of the path's exact legs, and adds the layers' pieces to the names.
void prove_exact_legs(std::span<const Layer> layers, Evidence& evidence);
// An end that is not free: it is in one of the layer's sums, or beyond one of the domain's sides.
Evidence end_evidence(const Layer& layer, ChainLink in, bool at_goal);
Evidence chain_evidence(const Layer& layer, const std::vector<ChainLink>& chain);

}  // namespace planner
