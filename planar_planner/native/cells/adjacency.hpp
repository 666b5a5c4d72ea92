// Which leaves of a subdivision, of any label, share a face of positive area: by walking the
// kd-tree once, since neighbour lists leave out FULL cells and blocked faces.
#pragma once

#include <algorithm>

#include "subdivision.hpp"

namespace planner {

namespace walk {

struct Node {
  std::uint32_t at;
  CellBox box;

  [[nodiscard]] bool leaf() const { return (at & Subdivision::kLeaf) != 0; }
  [[nodiscard]] CellId id() const { return at & ~Subdivision::kLeaf; }
};

struct Children {
  Node lower, upper;
  Axis axis;
};

inline Children children(const Subdivision& s, const Node& node) {
  const Subdivision::Branch& branch = s.branch(node.at);
  const Halves halves = halve(node.box, branch.axis);
  return {{branch.lower, halves.lower}, {branch.upper, halves.upper}, branch.axis};
}

inline bool overlap(const CellBox& a, const CellBox& b, const Axis axis) {
  return a.low[axis] < b.high(axis) && b.low[axis] < a.high(axis);
}

// All pairs of a leaf under `below` and one under `above` that meet in their common plane with
// normal `axis`, where `below` ends and `above` begins.
template <class Visit>
void between(const Subdivision& s, const Node& below, const Node& above, const Axis axis,
             const Visit& visit) {
  if (below.leaf() && above.leaf()) return visit(below.id(), above.id());
  const bool first = !below.leaf();
  const Node& inner = first ? below : above;
  const Node& other = first ? above : below;
  const Children c = children(s, inner);
  const auto go_on = [&](const Node& child) {
    first ? between(s, child, other, axis, visit) : between(s, other, child, axis, visit);
  };
  if (c.axis == axis) return go_on(first ? c.upper : c.lower);
  if (overlap(c.lower.box, other.box, c.axis)) go_on(c.lower);
  if (overlap(c.upper.box, other.box, c.axis)) go_on(c.upper);
}

template <class Visit>
void inside(const Subdivision& s, const Node& node, const Visit& visit) {
  if (node.leaf()) return;
  const Children c = children(s, node);
  inside(s, c.lower, visit);
  inside(s, c.upper, visit);
  between(s, c.lower, c.upper, c.axis, visit);
}

}  // namespace walk

// Calls visit(a, b) once for every two such leaves. (Leaves span at most a quarter turn, so two of
// them never share a second face across the seam.)
template <class Visit>
void visit_adjacent(const Subdivision& s, const Visit& visit) {
  const std::size_t parts = s.roots().size();
  for (std::size_t i = 0; i < parts; ++i) {
    const walk::Node node{s.roots()[i], s.root_box(i)};
    walk::inside(s, node, visit);
    const std::size_t next = (i + 1) % parts;
    if (next != i) walk::between(s, node, {s.roots()[next], s.root_box(next)}, kTheta, visit);
  }
}

}  // namespace planner
