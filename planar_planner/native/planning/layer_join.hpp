// Open places at quarter turns, and which of them are joined there exactly, by ways that may touch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/layers/layer.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// A configuration at a quarter turn inside a FREE leaf.
struct Gate {
  CellId cell;
  std::uint32_t region;     // of solid leaves
  std::uint32_t component;  // of the free translations at this angle, numbered over all layers
  std::size_t layer;        // place in Gates::layers
  Configuration at;
};

struct Gates {
  std::vector<Layer> layers;  // each at one quarter turn
  std::vector<Gate> gates;
  bool complete = true;  // no place was left out
};

enum class LayerJoin : std::uint8_t {
  kPath,     // is concluded
  kNone,     // no way joins the ends
  kUnknown,  // something was too large, or could not be certified
};

// Gates that are worth a try: of those regions of solid leaves that come to an angle in places
// which are joined there, by counts limited (tuning.hpp).
Gates find_gates(const ScaledProblem& problem, const Subdivision& subdivision,
                 const std::vector<std::uint32_t>& regions);

// A step from one node to the next: through solid leaves, or in a layer.
struct GateStep {
  std::size_t to;  // a gate; gates.size() is the goal
  bool in_layer;
};

// The fewest steps from a region to another; empty if the gates do not join them.
std::vector<GateStep> steps_between(const std::vector<Gate>& gates, std::uint32_t from,
                                    std::uint32_t to);

}  // namespace planner
