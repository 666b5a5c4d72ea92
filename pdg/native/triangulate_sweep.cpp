// From left to right through the vertices (Hertel and Mehlhorn, Fast Triangulation of Simple
// Polygons, 1983). Between two neighbouring active edges that bound the interior hangs a chain of
// vertices, from the left end of the lower edge to that of the upper one; left of it everything is
// triangulated. Each half of it, up to its last vertex and from there, is reflex: a new vertex
// cuts off what it sees of it.
//
// Why the triangles tile the interior: each is strictly counter-clockwise (exact), each interior
// edge has two of them, one on either side, and what is left over is the boundary; so a point is
// covered as often as the boundary winds round it. The rings are simple and disjoint, because
// neighbours in the order of active edges were tested whenever they became neighbours (Shamos and
// Hoey, 1976).
#include "triangulate_sweep.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "predicates.hpp"

namespace pdg {
namespace {

// Larger polygons are left to the other way: a sweep may leave slivers that take a number of flips
// that is quadratic.
constexpr std::size_t kMostVertices = 2048;

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// Two kinds of an edge of the chain have no triangle behind: the polygon's own, and a diagonal
// across which neither side has been triangulated yet, which is numbered.
constexpr Index diagonal_code(const std::size_t number) {
  return -2 - static_cast<Index>(number);
}

struct Link {
  Index vertex = kNone;
  Index prev = kNone;    // towards the lower edge
  Index next = kNone;    // towards the upper edge
  Index behind = kNone;  // half-edge from this vertex to the next, kNone or a diagonal's code
};

struct Chain {
  Index low = kNone;   // link at the lower edge
  Index high = kNone;  // link at the upper edge
  Index last = kNone;  // link of the rightmost vertex
};

struct ActiveEdge {
  Index left = kNone;
  Index right = kNone;
  std::size_t chain = 0;  // of the interior above it; only of every other edge
};

class Sweep {
 public:
  explicit Sweep(const Polygon& polygon) : polygon_(polygon) {}

  std::optional<PointMesh> run() {
    if (!sort_vertices()) return std::nullopt;
    for (Index v = 0; v < static_cast<Index>(mesh_.points.size()); ++v)
      if (!meet(v)) return std::nullopt;
    if (!mark_boundary()) return std::nullopt;
    return std::move(mesh_);
  }

 private:
  bool sort_vertices();
  bool meet(Index v);
  bool start(Index v, std::size_t place);
  bool bend(Index v, std::size_t place);
  bool end(Index v, std::size_t place);
  void open(Index v, std::size_t place);
  void split(Index v, std::size_t place);
  bool close(Index v, std::size_t place);
  void merge(Index v, std::size_t place);
  [[nodiscard]] bool neighbours_apart(std::size_t below, std::size_t above) const;
  [[nodiscard]] int side_of(const ActiveEdge& edge, Index v) const;
  Index add_link(Index vertex);
  void join(Index a, Index b, Index behind);
  bool cut(Index link);
  void cut_upwards_from(Index link);
  void cut_downwards_from(Index link);
  Index prepend(Chain& chain, Index v);
  Index append(Chain& chain, Index v);
  void settle(Index behind, Index half_edge);
  bool mark_boundary();

  const Polygon& polygon_;
  PointMesh mesh_;
  std::vector<std::array<Index, 2>> neighbours_;  // of each vertex, on its ring
  std::vector<ActiveEdge> active_;                // from below
  std::vector<Chain> chains_;
  std::vector<Link> links_;
  std::vector<Index> diagonals_;  // by number: the half-edge of the first triangle at it
};

bool Sweep::sort_vertices() {
  std::vector<Vec2> given;
  std::vector<std::size_t> ring_starts{0};
  for (const Ring& ring : polygon_.rings) {
    for (const Vec2 p : ring) given.push_back({p.x + 0.0, p.y + 0.0});  // -0 and 0 are the same
    ring_starts.push_back(given.size());
  }
  const std::size_t n = given.size();
  if (n > kMostVertices || !std::all_of(given.begin(), given.end(), in_exact_range)) return false;
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](const Index a, const Index b) {
    return lexicographically_less(given[at(a)], given[at(b)]);
  });
  std::vector<Index> rank(n);
  mesh_.points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    rank[at(order[i])] = static_cast<Index>(i);
    mesh_.points.push_back(given[at(order[i])]);
    if (i > 0 && !lexicographically_less(mesh_.points[i - 1], mesh_.points[i])) return false;
  }
  neighbours_.resize(n);
  for (std::size_t r = 0; r + 1 < ring_starts.size(); ++r)
    for (std::size_t i = ring_starts[r]; i < ring_starts[r + 1]; ++i) {
      const std::size_t next = i + 1 < ring_starts[r + 1] ? i + 1 : ring_starts[r];
      neighbours_[at(rank[i])][1] = rank[next];
      neighbours_[at(rank[next])][0] = rank[i];
    }
  mesh_.outgoing.assign(n, kNone);
  mesh_.hull_edge.assign(n, kNone);
  mesh_.origin.reserve(3 * n);
  mesh_.twin.reserve(3 * n);
  mesh_.fixed.reserve(3 * n);
  mesh_.odd.reserve(3 * n);
  mesh_.least_sine.reserve(n);
  links_.reserve(2 * n);
  return true;
}

// Each step returns whether it met nothing but a simple polygon in general position.
bool Sweep::meet(const Index v) {
  const auto below = [&](const ActiveEdge& edge) { return side_of(edge, v) > 0; };
  const auto place = static_cast<std::size_t>(
      std::partition_point(active_.begin(), active_.end(), below) - active_.begin());
  const auto& [a, b] = neighbours_[at(v)];
  if (a > v && b > v) return start(v, place);
  return a < v && b < v ? end(v, place) : bend(v, place);
}

int Sweep::side_of(const ActiveEdge& edge, const Index v) const {
  return orient2d(mesh_.point(edge.left), mesh_.point(edge.right), mesh_.point(v));
}

// Whether the edge at the second place stays above the other up to where the first of them ends;
// they may end together.
bool Sweep::neighbours_apart(const std::size_t below, const std::size_t above) const {
  if (above == 0 || above >= active_.size()) return true;
  const ActiveEdge& low = active_[below];
  const ActiveEdge& high = active_[above];
  if (low.right == high.right) return true;
  return low.right < high.right ? side_of(high, low.right) < 0 : side_of(low, high.right) > 0;
}

bool Sweep::start(const Index v, const std::size_t place) {
  if (place < active_.size() && side_of(active_[place], v) == 0) return false;
  auto [low, high] = neighbours_[at(v)];
  const int turn = orient2d(mesh_.point(v), mesh_.point(low), mesh_.point(high));
  if (turn == 0) return false;
  if (turn < 0) std::swap(low, high);
  const std::array<ActiveEdge, 2> edges{ActiveEdge{v, low, 0}, ActiveEdge{v, high, 0}};
  active_.insert(active_.begin() + static_cast<std::ptrdiff_t>(place), edges.begin(), edges.end());
  place % 2 == 0 ? open(v, place) : split(v, place);
  return neighbours_apart(place - 1, place) && neighbours_apart(place + 1, place + 2);
}

bool Sweep::bend(const Index v, const std::size_t place) {
  if (place >= active_.size() || active_[place].right != v) return false;
  const auto& [a, b] = neighbours_[at(v)];
  active_[place] = {v, std::max(a, b), active_[place].chain};
  if (place % 2 == 0) {
    cut_upwards_from(prepend(chains_[active_[place].chain], v));
  } else {
    cut_downwards_from(append(chains_[active_[place - 1].chain], v));
  }
  return neighbours_apart(place - 1, place) && neighbours_apart(place, place + 1);
}

bool Sweep::end(const Index v, const std::size_t place) {
  if (place + 1 >= active_.size() || active_[place].right != v || active_[place + 1].right != v)
    return false;
  if (place % 2 != 0)
    merge(v, place);
  else if (!close(v, place))
    return false;
  const auto first = active_.begin() + static_cast<std::ptrdiff_t>(place);
  active_.erase(first, first + 2);
  return neighbours_apart(place - 1, place);
}

// The interior begins at v.
void Sweep::open(const Index v, const std::size_t place) {
  const Index link = add_link(v);
  active_[place].chain = chains_.size();
  chains_.push_back({link, link, link});
}

// The boundary begins at v, inside: the diagonal from v to the last vertex divides the chain.
void Sweep::split(const Index v, const std::size_t place) {
  Chain& lower = chains_[active_[place - 1].chain];
  const Link last = links_[at(lower.last)];
  const Index code = diagonal_code(diagonals_.size());
  diagonals_.push_back(kNone);
  Chain upper;
  upper.low = upper.last = add_link(v);
  const Index copy = add_link(last.vertex);
  join(upper.low, copy, code);
  upper.high = lower.high == lower.last ? copy : lower.high;
  if (last.next != kNone) join(copy, last.next, last.behind);
  const Index end = add_link(v);
  join(lower.last, end, code);
  lower.high = lower.last = end;
  cut_downwards_from(end);
  cut_upwards_from(upper.low);
  active_[place + 1].chain = chains_.size();
  chains_.push_back(upper);
}

// The interior ends at v, which must see the whole chain.
bool Sweep::close(const Index v, const std::size_t place) {
  Chain& chain = chains_[active_[place].chain];
  if (chain.low == chain.high) return false;
  const Index high = chain.high;
  const Index link = prepend(chain, v);
  cut_upwards_from(link);
  return links_[at(link)].next == high;
}

// The boundary between two chains ends at v, which joins them.
void Sweep::merge(const Index v, const std::size_t place) {
  Chain& lower = chains_[active_[place - 1].chain];
  Chain& upper = chains_[active_[place + 1].chain];
  const Index end = append(lower, v);
  cut_downwards_from(end);
  const Index begin = prepend(upper, v);
  cut_upwards_from(begin);
  join(end, links_[at(begin)].next, links_[at(begin)].behind);
  lower.high = upper.high == begin ? end : upper.high;
}

Index Sweep::add_link(const Index vertex) {
  links_.push_back({vertex, kNone, kNone, kNone});
  return static_cast<Index>(links_.size() - 1);
}

void Sweep::join(const Index a, const Index b, const Index behind) {
  links_[at(a)].next = b;
  links_[at(a)].behind = behind;
  links_[at(b)].prev = a;
}

Index Sweep::prepend(Chain& chain, const Index v) {
  const Index link = add_link(v);
  join(link, chain.low, kNone);
  chain.low = chain.last = link;
  return link;
}

Index Sweep::append(Chain& chain, const Index v) {
  const Index link = add_link(v);
  join(chain.high, link, kNone);
  chain.high = chain.last = link;
  return link;
}

// Takes the link out of the chain if the triangle with its neighbours lies to its right.
bool Sweep::cut(const Index link) {
  const Link middle = links_[at(link)];
  const Link& below = links_[at(middle.prev)];
  const Index x = below.vertex;
  const Index z = links_[at(middle.next)].vertex;
  if (orient2d(mesh_.point(x), mesh_.point(z), mesh_.point(middle.vertex)) <= 0) return false;
  const Index h = add_triangle(mesh_, x, z, middle.vertex);
  settle(middle.behind, h + 1);
  settle(below.behind, h + 2);
  join(middle.prev, middle.next, h);
  return true;
}

void Sweep::cut_upwards_from(const Index link) {
  for (Index next = links_[at(link)].next; links_[at(next)].next != kNone && cut(next);)
    next = links_[at(link)].next;
}

void Sweep::cut_downwards_from(const Index link) {
  for (Index prev = links_[at(link)].prev; links_[at(prev)].prev != kNone && cut(prev);)
    prev = links_[at(link)].prev;
}

// The half-edge of a new triangle meets what lies behind that edge of the chain.
void Sweep::settle(const Index behind, const Index half_edge) {
  if (behind >= kNone) return link(mesh_, half_edge, behind);
  Index& first = diagonals_[at(-2 - behind)];
  if (first == kNone)
    first = half_edge;
  else
    link(mesh_, half_edge, first);
}

// False if the edges left over are not the polygon's.
bool Sweep::mark_boundary() {
  std::size_t count = 0;
  for (std::size_t h = 0; h < mesh_.twin.size(); ++h) {
    if (mesh_.twin[h] != kNone) continue;
    mesh_.odd[h] = 1;
    ++count;
  }
  return active_.empty() && count == mesh_.points.size();
}

}  // namespace

std::optional<PointMesh> triangulate_sweep(const Polygon& polygon) {
  return Sweep(polygon).run();
}

}  // namespace pdg
