#include "barrier.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "minimum_cut.hpp"
#include "planar_planner/native/cells/adjacency.hpp"

namespace planner {

namespace {

struct Pair {
  CellId a, b;
};

bool full(const Subdivision& s, const CellId id) {
  return s.cell(id).label == Label::kFull;
}

// Pairs of adjacent leaves, by what can be done between them.
struct Adjacent {
  std::vector<Pair> open;     // both open and linked: always passable
  std::vector<Pair> blocked;  // both open, but their common face is in C-obstacle
  std::vector<Pair> full;     // one or both are FULL
};

Adjacent adjacent_pairs(const Subdivision& s) {
  Adjacent out;
  visit_adjacent(s, [&](const CellId a, const CellId b) {
    const bool linked = !full(s, a) && !full(s, b) && s.linked(a, b);
    (linked ? out.open : full(s, a) || full(s, b) ? out.full : out.blocked).push_back({a, b});
  });
  return out;
}

// Sets of open leaves that no cut can part: union-find with path halving.
class Merged {
 public:
  explicit Merged(const std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), CellId{0});
  }
  CellId find(CellId id) {
    while (parent_[id] != id) id = parent_[id] = parent_[parent_[id]];
    return id;
  }
  void unite(const CellId a, const CellId b) { parent_[find(a)] = find(b); }

 private:
  std::vector<CellId> parent_;
};

// The flow network: a FULL leaf can be cut, so it has a way in and a way out; open leaves that are
// linked are one node.
struct Network {
  std::vector<std::uint32_t> in, out;  // by leaf
  std::uint32_t nodes = 0;

  Network(const Subdivision& s, const Adjacent& pairs) : in(s.size()), out(s.size()) {
    Merged merged(s.size());
    for (const Pair& pair : pairs.open) merged.unite(pair.a, pair.b);
    for (CellId id = 0; id < s.size(); ++id) {
      if (merged.find(id) != id) continue;
      in[id] = nodes++;
      out[id] = full(s, id) ? nodes++ : in[id];
    }
    for (CellId id = 0; id < s.size(); ++id) {
      in[id] = in[merged.find(id)];
      out[id] = out[merged.find(id)];
    }
  }
};

// Adds the passable arcs, once each.
void add_arcs(const Subdivision& s, const Adjacent& pairs, const Network& network,
              MinimumCut& cut) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
  for (const auto& [a, b] : pairs.full) {
    arcs.emplace_back(network.out[a], network.in[b]);
    arcs.emplace_back(network.out[b], network.in[a]);
  }
  std::sort(arcs.begin(), arcs.end());
  arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
  for (const auto& [u, v] : arcs) cut.add_arc(u, v, MinimumCut::kUncuttable, 0);
  for (const auto& [a, b] : pairs.blocked)
    if (network.in[a] != network.in[b]) cut.add_arc(network.out[a], network.in[b], 1, 1);
  for (CellId id = 0; id < s.size(); ++id)
    if (full(s, id)) cut.add_arc(network.in[id], network.out[id], 1, 0);
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
  const Adjacent pairs = adjacent_pairs(s);
  const Network network(s, pairs);
  const std::uint32_t source = network.nodes;
  const std::uint32_t sink = source + 1;
  MinimumCut cut(network.nodes + 2);
  add_arcs(s, pairs, network, cut);
  constexpr std::uint32_t kAll = MinimumCut::kUncuttable;
  for (const CellId id : start)
    if (!full(s, id)) cut.add_arc(source, network.in[id], kAll, 0);
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
  for (const Pair& pair : pairs.blocked)
    if (start_side[pair.a] != start_side[pair.b]) crossed.push_back(pair);
  barrier.faces = face_claims(s, blocked, crossed);
  return barrier;
}

}  // namespace planner
