// From left to right through the vertices (Hertel and Mehlhorn, Fast Triangulation of Simple
// Polygons, 1983). Between two neighbouring active edges that bound the interior hangs a chain of
// vertices, from the left end of the lower edge to that of the upper one; left of it everything is
// triangulated. Each half of it, up to its last vertex and from there, is reflex: a new vertex
// cuts off what it sees of it.
//
// Why the triangles tile the interior: the rings are simple and disjoint, for the sweep went
// through; each triangle is strictly counter-clockwise (exact), each interior edge has two of them,
// one on either side, and what is left over is the boundary; so a point is covered as often as the
// boundary winds round it.
#include "triangulate_sweep.hpp"

#include <cstddef>
#include <utility>

#include "ring_sweep.hpp"

namespace pdg {
namespace {

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

// The interior for RingSweep; its regions are the chains.
class Chains {
 public:
  explicit Chains(const std::vector<Vec2>& points);

  Index open(Index v);
  Index split(Index v, Index region, std::size_t place);
  void lower(Index v, Index region);
  void upper(Index v, Index region);
  bool close(Index v, Index region);
  void merge(Index v, Index lower, Index upper);

  // Marks the boundary. Nothing if the edges left over are not the polygon's.
  std::optional<PointMesh> take_mesh();

 private:
  Chain& chain(const Index region) { return chains_[at(region)]; }
  Index add_chain(const Chain& chain);
  Index add_link(Index vertex);
  void join(Index a, Index b, Index behind);
  bool cut(Index link);
  void cut_upwards_from(Index link);
  void cut_downwards_from(Index link);
  Index prepend(Chain& chain, Index v);
  Index append(Chain& chain, Index v);
  void settle(Index behind, Index half_edge);

  PointMesh mesh_;
  std::vector<Chain> chains_;
  std::vector<Link> links_;
  std::vector<Index> diagonals_;  // by number: the half-edge of the first triangle at it
};

Chains::Chains(const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  mesh_.points = points;
  mesh_.outgoing.assign(n, kNone);
  mesh_.hull_edge.assign(n, kNone);
  mesh_.origin.reserve(3 * n);
  mesh_.twin.reserve(3 * n);
  mesh_.fixed.reserve(3 * n);
  mesh_.odd.reserve(3 * n);
  mesh_.least_sine.reserve(n);
  links_.reserve(2 * n);
}

Index Chains::add_chain(const Chain& chain) {
  chains_.push_back(chain);
  return static_cast<Index>(chains_.size() - 1);
}

Index Chains::open(const Index v) {
  const Index link = add_link(v);
  return add_chain({link, link, link});
}

// The diagonal from v to the last vertex divides the chain.
Index Chains::split(const Index v, const Index region, std::size_t) {
  Chain& lower = chain(region);
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
  return add_chain(upper);
}

void Chains::lower(const Index v, const Index region) {
  cut_upwards_from(prepend(chain(region), v));
}

void Chains::upper(const Index v, const Index region) {
  cut_downwards_from(append(chain(region), v));
}

// The last vertex must see the whole chain.
bool Chains::close(const Index v, const Index region) {
  Chain& last = chain(region);
  if (last.low == last.high) return false;
  const Index high = last.high;
  const Index link = prepend(last, v);
  cut_upwards_from(link);
  return links_[at(link)].next == high;
}

void Chains::merge(const Index v, const Index lower, const Index upper) {
  Chain& low = chain(lower);
  Chain& high = chain(upper);
  const Index end = append(low, v);
  cut_downwards_from(end);
  const Index begin = prepend(high, v);
  cut_upwards_from(begin);
  join(end, links_[at(begin)].next, links_[at(begin)].behind);
  low.high = high.high;
}

Index Chains::add_link(const Index vertex) {
  links_.push_back({vertex, kNone, kNone, kNone});
  return static_cast<Index>(links_.size() - 1);
}

void Chains::join(const Index a, const Index b, const Index behind) {
  links_[at(a)].next = b;
  links_[at(a)].behind = behind;
  links_[at(b)].prev = a;
}

Index Chains::prepend(Chain& chain, const Index v) {
  const Index link = add_link(v);
  join(link, chain.low, kNone);
  chain.low = chain.last = link;
  return link;
}

Index Chains::append(Chain& chain, const Index v) {
  const Index link = add_link(v);
  join(chain.high, link, kNone);
  chain.high = chain.last = link;
  return link;
}

// Takes the link out of the chain if the triangle with its neighbours lies to its right.
bool Chains::cut(const Index link) {
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

void Chains::cut_upwards_from(const Index link) {
  for (Index next = links_[at(link)].next; links_[at(next)].next != kNone && cut(next);)
    next = links_[at(link)].next;
}

void Chains::cut_downwards_from(const Index link) {
  for (Index prev = links_[at(link)].prev; links_[at(prev)].prev != kNone && cut(prev);)
    prev = links_[at(link)].prev;
}

// The half-edge of a new triangle meets what lies behind that edge of the chain.
void Chains::settle(const Index behind, const Index half_edge) {
  if (behind >= kNone) return link(mesh_, half_edge, behind);
  Index& first = diagonals_[at(-2 - behind)];
  if (first == kNone)
    first = half_edge;
  else
    link(mesh_, half_edge, first);
}

std::optional<PointMesh> Chains::take_mesh() {
  std::size_t count = 0;
  for (std::size_t h = 0; h < mesh_.twin.size(); ++h) {
    if (mesh_.twin[h] != kNone) continue;
    mesh_.odd[h] = 1;
    ++count;
  }
  if (count != mesh_.points.size()) return std::nullopt;
  return std::move(mesh_);
}

}  // namespace

std::optional<PointMesh> triangulate_sweep(const Polygon& polygon) {
  const SweepVertices vertices = sort_vertices(polygon);
  Chains chains(vertices.points);
  if (vertices.points.empty() || !RingSweep(vertices, chains).run()) return std::nullopt;
  return chains.take_mesh();
}

}  // namespace pdg
