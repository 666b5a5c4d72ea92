#include "layer_join.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "layer_decision.hpp"
#include "planar_planner/native/cells/solid_regions.hpp"
#include "planar_planner/native/configurations/dyadic_box.hpp"
#include "planar_planner/native/configurations/quarter_turn.hpp"
#include "planar_planner/native/layers/odd_chain.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

struct Place {
  CellId cell;
  Vec2 at;      // user's units, a multiple of step
  double step;  // a power of two
};

// A point near the middle of a leaf with as few bits as keep it inside.
Place place_in(const ScaledProblem& problem, const Subdivision& subdivision, const CellId cell) {
  const CellBox& box = subdivision.cell(cell).box;
  const CellSpace& space = subdivision.space();
  const auto corner = [&](const std::uint64_t x, const std::uint64_t y) {
    return to_user(problem, position_of(space, x, y));
  };
  const Vec2 low = corner(box.low[kX], box.low[kY]);
  const Vec2 high = corner(box.high(kX), box.high(kY));
  const double step = std::ldexp(1.0, std::ilogb(std::min(high.x - low.x, high.y - low.y)) - 2);
  const auto middle = [&](const double a, const double b) {
    return step * std::round(0.5 * (a + b) / step);
  };
  return {cell, {middle(low.x, high.x), middle(low.y, high.y)}, step};
}

std::vector<Place> places_at(const ScaledProblem& problem, const Subdivision& subdivision,
                             const int quarters, bool& complete) {
  std::vector<CellId> leaves = free_leaves_at(subdivision, quarters);
  if (leaves.size() > kMostGates) {
    leaves.resize(kMostGates);
    complete = false;
  }
  std::vector<Place> places;
  for (const CellId leaf : leaves) places.push_back(place_in(problem, subdivision, leaf));
  return places;
}

// Numbers the components of the free translations in which the places lie, from 0; empty if that
// would be too much work.
std::optional<std::vector<std::uint32_t>> components_of(Layer& layer,
                                                        const std::vector<LatticePoint>& places) {
  std::size_t tests = kGateWork / std::max<std::size_t>(1, layer.sums.size());
  std::vector<std::uint32_t> component;
  std::vector<LatticePoint> first;  // of each component
  std::vector<std::int32_t> scratch;
  for (const LatticePoint p : places) {
    std::uint32_t own = 0;
    layer.goal = p;
    if (!is_free(layer, p, scratch)) return std::nullopt;
    for (; own < first.size(); ++own) {
      if (tests-- == 0) return std::nullopt;
      layer.start = first[own];
      if (!find_odd_chain(layer)) break;
    }
    if (own == first.size()) first.push_back(p);
    component.push_back(own);
  }
  return component;
}

}  // namespace

Gates find_gates(const ScaledProblem& problem, const Subdivision& subdivision,
                 const std::vector<std::uint32_t>& regions) {
  Gates out;
  std::uint32_t numbered = 0;
  for (int quarters = 0; quarters < 4; ++quarters) {
    const std::vector<Place> places = places_at(problem, subdivision, quarters, out.complete);
    if (places.size() < 2) continue;
    const double finest =
        std::min_element(places.begin(), places.end(), [](const Place& a, const Place& b) {
          return a.step < b.step;
        })->step;
    std::optional<Layer> layer =
        make_layer(problem, {quarters, places[0].at, places[0].at, finest}, kLayerLimits);
    out.complete = out.complete && layer;
    if (!layer) continue;
    std::vector<LatticePoint> points;
    for (const Place& place : places) points.push_back(to_lattice(layer->lattice, place.at));
    const auto components = components_of(*layer, points);
    out.complete = out.complete && components;
    if (!components) continue;
    for (std::size_t i = 0; i < places.size(); ++i)
      out.gates.push_back({places[i].cell,
                           regions[places[i].cell],
                           numbered + (*components)[i],
                           out.layers.size(),
                           {places[i].at.x, places[i].at.y, radians_of_quarters(quarters)}});
    numbered += *std::max_element(components->begin(), components->end()) + 1;
    out.layers.push_back(std::move(*layer));
  }
  return out;
}

std::vector<GateStep> steps_between(const std::vector<Gate>& gates, const std::uint32_t from,
                                    const std::uint32_t to) {
  const std::size_t none = gates.size();
  struct Node {
    std::size_t before;
    bool reached = false;
    bool in_layer = false;
  };
  std::vector<Node> nodes(gates.size(), {none});
  std::deque<std::size_t> open;
  const auto visit = [&](const std::size_t gate, const std::size_t before, const bool in_layer) {
    if (nodes[gate].reached) return;
    nodes[gate] = {before, true, in_layer};
    open.push_back(gate);
  };
  for (std::size_t i = 0; i < gates.size(); ++i)
    if (gates[i].region == from) visit(i, none, false);
  while (!open.empty()) {
    const std::size_t here = open.front();
    open.pop_front();
    if (gates[here].region == to) {
      std::vector<GateStep> steps{{none, false}};
      for (std::size_t at = here; at != none; at = nodes[at].before)
        steps.push_back({at, nodes[at].in_layer});
      std::reverse(steps.begin(), steps.end());
      return steps;
    }
    for (std::size_t i = 0; i < gates.size(); ++i) {
      if (gates[i].component == gates[here].component) visit(i, here, true);
      if (gates[i].region == gates[here].region) visit(i, here, false);
    }
  }
  return {};
}

}  // namespace planner
