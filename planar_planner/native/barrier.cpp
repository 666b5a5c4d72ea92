#include "barrier.hpp"

#include "adjacency.hpp"
#include "minimum_cut.hpp"

namespace planner {

namespace {

// A leaf as nodes of the flow network: a FULL one can be cut, so it has a way in and a way out.
struct Network {
  std::vector<std::uint32_t> in, out;  // by leaf
  std::size_t nodes = 0;

  explicit Network(const Subdivision& s) : in(s.size()), out(s.size()) {
    for (CellId id = 0; id < s.size(); ++id) {
      in[id] = static_cast<std::uint32_t>(nodes++);
      out[id] = s.cell(id).label == Label::kFull ? static_cast<std::uint32_t>(nodes++) : in[id];
    }
  }
};

struct Pair {
  CellId a, b;
};

// Both leaves are open, but every configuration of their common face is in C-obstacle.
bool blocked_pair(const Subdivision& s, const CellId a, const CellId b) {
  return s.cell(a).label != Label::kFull && s.cell(b).label != Label::kFull && !s.linked(a, b);
}

// Emits the largest nodes of the kd-tree that lie wholly in the set; true if `node` does.
bool collect_boxes(const Subdivision& s, const walk::Node& node, const std::vector<bool>& in_set,
                   std::vector<CellBox>& out) {
  if (node.leaf()) {
    if (!in_set[node.id()]) return false;
    out.push_back(node.box);
    return true;
  }
  const walk::Children c = walk::children(s, node);
  const std::size_t before = out.size();
  const bool lower = collect_boxes(s, c.lower, in_set, out);
  const bool upper = collect_boxes(s, c.upper, in_set, out);
  if (!lower || !upper) return false;
  out.resize(before);
  out.push_back(node.box);
  return true;
}

bool meet(const Extent& a, const Extent& b, const Axis flat, const bool rotation) {
  for (Axis k = 0; k < kNoAxis; ++k) {
    if (k == flat ? a.low[k] != b.low[k]
                  : (k != kTheta || rotation) &&
                        !(a.low[k] < b.low[k] + b.size[k] && b.low[k] < a.low[k] + a.size[k]))
      return false;
  }
  return true;
}

// The claims that cover the common faces of the pairs.
std::vector<FullClaim> face_claims(const Subdivision& s, const std::vector<FullClaim>& blocked,
                                   const std::vector<Pair>& pairs) {
  std::vector<FullClaim> out;
  std::vector<bool> used(blocked.size());
  for (const Pair& pair : pairs) {
    Axis axis = kNoAxis;
    adjacent(s.cell(pair.a).box, s.cell(pair.b).box, axis);
    const Extent face = common_face(s.cell(pair.a).box, s.cell(pair.b).box, axis);
    for (std::size_t i = 0; i < blocked.size(); ++i) {
      if (used[i] || blocked[i].flat != axis) continue;
      used[i] = meet(blocked[i].box, face, axis, s.space().rotation);
      if (used[i]) out.push_back(blocked[i]);
    }
  }
  return out;
}

}  // namespace

Barrier find_barrier(const Subdivision& s, const std::vector<FullClaim>& blocked,
                     const std::span<const CellId> start, const std::span<const CellId> goal) {
  const Network network(s);
  const auto source = static_cast<std::uint32_t>(network.nodes);
  const std::uint32_t sink = source + 1;
  MinimumCut cut(network.nodes + 2);
  for (CellId id = 0; id < s.size(); ++id)
    if (network.in[id] != network.out[id]) cut.add_arc(network.in[id], network.out[id], 1, 0);
  std::vector<Pair> blocked_pairs;
  constexpr std::uint32_t kAll = MinimumCut::kUncuttable;
  visit_adjacent(s, [&](const CellId a, const CellId b) {
    if (blocked_pair(s, a, b)) {
      blocked_pairs.push_back({a, b});
      cut.add_arc(network.out[a], network.in[b], 1, 1);
    } else if (network.in[a] == network.out[a] && network.in[b] == network.out[b]) {
      cut.add_arc(network.in[a], network.in[b], kAll, kAll);
    } else {
      cut.add_arc(network.out[a], network.in[b], kAll, 0);
      cut.add_arc(network.out[b], network.in[a], kAll, 0);
    }
  });
  for (const CellId id : start)
    if (s.cell(id).label != Label::kFull) cut.add_arc(source, network.in[id], kAll, 0);
  for (const CellId id : goal) cut.add_arc(network.out[id], sink, kAll, 0);
  Barrier barrier;
  if (cut.solve(source, sink) >= kAll) return barrier;

  std::vector<bool> start_side(s.size());
  for (CellId id = 0; id < s.size(); ++id) {
    start_side[id] = cut.on_source_side(network.out[id]);
    if (cut.on_source_side(network.in[id]) && !start_side[id]) barrier.cells.push_back(s.claim(id));
  }
  for (std::size_t i = 0; i < s.roots().size(); ++i)
    collect_boxes(s, {s.roots()[i], s.root_box(i)}, start_side, barrier.start_side);
  std::vector<Pair> crossed;
  for (const Pair& pair : blocked_pairs)
    if (start_side[pair.a] != start_side[pair.b]) crossed.push_back(pair);
  barrier.faces = face_claims(s, blocked, crossed);
  return barrier;
}

}  // namespace planner
