// A plane sweep over the rings of a polygon, from left to right, that also finds out whether they
// are simple and apart from each other. What lies between the rings is another's business.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "point_mesh.hpp"

namespace pdg {

// An edge that the sweep line crosses; its ends are in the order of the sweep.
struct ActiveEdge {
  Index left = kNone;
  Index right = kNone;
  Index region = kNone;  // of the interior above it; only of every other edge, from the lowest on
};

// The rings' vertices from left to right, on a vertical line from below.
struct SweepVertices {
  std::vector<Vec2> points;
  std::vector<std::array<Index, 2>> neighbours;  // of each, on its ring
  std::vector<Index> rings;                      // of each
};

// Nothing (no points) if a vertex comes twice or a coordinate is out of range of predicates.hpp.
SweepVertices sort_vertices(const Polygon& polygon);

// Calls `interior` for every vertex v, with the regions between active edges that it concerns:
//   open(v) -> region       the interior begins at v
//   split(v, region, place) -> region   the boundary begins at v inside the region; the upper part
//   lower(v, region), upper(v, region)  the region's lower or upper edge bends at v
//   close(v, region)        the interior ends at v
//   merge(v, lower, upper)  the boundary between two regions ends at v; `lower` goes on as both
// (`place`: so many active edges are below v.) False, at once, if one of them returns false (where
// it returns bool) or something touches: a vertex on an edge, edges that cross or overlap.
// Neighbours in the order of active edges are compared whenever they become neighbours, so nothing
// is missed (Shamos and Hoey, Geometric Intersection Problems, 1976).
template <class Interior>
class RingSweep {
 public:
  RingSweep(const SweepVertices& vertices, Interior& interior)
      : vertices_(vertices), interior_(interior) {}

  bool run() {
    for (Index v = 0; v < static_cast<Index>(vertices_.points.size()); ++v)
      if (!meet(v)) return false;
    return active_.empty();
  }

  [[nodiscard]] const std::vector<ActiveEdge>& active() const { return active_; }

 private:
  static constexpr std::size_t at(const Index i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] Vec2 point(const Index v) const { return vertices_.points[at(v)]; }

  // +1: v is above the edge.
  [[nodiscard]] int side_of(const ActiveEdge& edge, const Index v) const {
    return orient2d(point(edge.left), point(edge.right), point(v));
  }

  bool meet(const Index v) {
    std::size_t place = 0;
    for (std::size_t above = active_.size(); place < above;) {
      const std::size_t middle = place + (above - place) / 2;
      if (side_of(active_[middle], v) > 0)
        place = middle + 1;
      else
        above = middle;
    }
    const auto& [a, b] = vertices_.neighbours[at(v)];
    if (a > v && b > v) return start(v, place);
    return a < v && b < v ? end(v, place) : bend(v, place);
  }

  // Whether the edge at the second place stays above the other up to where the first of them ends;
  // they may end together.
  [[nodiscard]] bool apart(const std::size_t below, const std::size_t above) const {
    if (above == 0 || above >= active_.size()) return true;
    const ActiveEdge& low = active_[below];
    const ActiveEdge& high = active_[above];
    if (low.right == high.right) return true;
    return low.right < high.right ? side_of(high, low.right) < 0 : side_of(low, high.right) > 0;
  }

  bool start(const Index v, const std::size_t place) {
    if (place < active_.size() && side_of(active_[place], v) == 0) return false;
    auto [low, high] = vertices_.neighbours[at(v)];
    const int turn = orient2d(point(v), point(low), point(high));
    if (turn == 0) return false;
    if (turn < 0) std::swap(low, high);
    const bool inside = place % 2 != 0;
    const Index region =
        inside ? interior_.split(v, active_[place - 1].region, place) : interior_.open(v);
    const std::array<ActiveEdge, 2> edges{ActiveEdge{v, low, inside ? kNone : region},
                                          ActiveEdge{v, high, inside ? region : kNone}};
    active_.insert(active_.begin() + static_cast<std::ptrdiff_t>(place), edges.begin(),
                   edges.end());
    return apart(place - 1, place) && apart(place + 1, place + 2);
  }

  bool bend(const Index v, const std::size_t place) {
    if (place >= active_.size() || active_[place].right != v) return false;
    const auto& [a, b] = vertices_.neighbours[at(v)];
    active_[place] = {v, std::max(a, b), active_[place].region};
    if (place % 2 == 0)
      interior_.lower(v, active_[place].region);
    else
      interior_.upper(v, active_[place - 1].region);
    return apart(place - 1, place) && apart(place, place + 1);
  }

  bool end(const Index v, const std::size_t place) {
    if (place + 1 >= active_.size() || active_[place].right != v || active_[place + 1].right != v)
      return false;
    if (place % 2 != 0)
      interior_.merge(v, active_[place - 1].region, active_[place + 1].region);
    else if (!interior_.close(v, active_[place].region))
      return false;
    const auto first = active_.begin() + static_cast<std::ptrdiff_t>(place);
    active_.erase(first, first + 2);
    return apart(place - 1, place);
  }

  const SweepVertices& vertices_;
  Interior& interior_;
  std::vector<ActiveEdge> active_;  // from below
};

}  // namespace pdg
