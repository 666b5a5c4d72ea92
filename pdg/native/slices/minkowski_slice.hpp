// The C-obstacle at one angle as a union of open convex polygons, and the least value of a convex
// function of the translation outside it.
//
// The interiors of regular bodies A = union of A_i and B = union of B_j meet iff those of some A_i
// and B_j do: what two open sets have in common is open and not covered by the pieces' edges. So
// the obstacle is exactly the union of the open polygons B_j + (-A_i), and edges that pieces share
// leave no seam: on the line where two sums abut lies the inside of a third.
//
// Rounding. Let e = ObstacleSlice::error bound, for |t| up to the cut-off's reach, the difference
// between the computed and the exact value of every normal . t - offset. A point counts as covered
// by a polygon only where it lies deeper than a slack inside every half-plane.
//   kBound: slack 3 e. No exactly free point is taken for covered, so the result is at most
//   4 e + the least value over the exactly free points (a proof stands at least_outside).
//   kValue: slack e / 2, more than what rounding does in all but the worst case; plain doubles, off
//   by about e / 2 over the sine of the angle between the two edges that meet at the result.
// In both, gaps narrower than the slack, between bodies or left by bodies that are themselves so
// thin, are taken for free.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "farthest_point.hpp"
#include "pdg/native/geometry/box_tree.hpp"
#include "pdg/native/geometry/vec.hpp"

namespace pdg {

// The open half-plane normal . t < offset; unit normal up to 8 u.
struct SlicePlane {
  Vec2 normal;
  double offset = 0.0;
};

// A convex piece in the slice's frame.
struct SlicePiece {
  std::span<const Vec2> vertices;  // strictly convex, counter-clockwise
  std::span<const Vec2> normals;   // outward unit normal of the edge from vertex k to k + 1
  Box box;
};

// min over v of normal . v.
inline double least_along(const Vec2 normal, const std::span<const Vec2> vertices) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 v : vertices) least = std::min(least, dot(normal, v));
  return least;
}

struct ObstacleSlice {
  struct Polygon {
    Box box;
    std::uint32_t begin = 0;  // its half-planes are planes[begin .. end)
    std::uint32_t end = 0;
    std::int32_t piece_a = -1;
    std::int32_t piece_b = -1;
  };
  std::vector<SlicePlane> planes;
  std::vector<Polygon> polygons;
  double error = 0.0;  // e above (length)
};

// {b - a}: the box that holds B_j + (-A_i).
constexpr Box difference_box(const Box& a, const Box& b) {
  return {{b.low.x - a.high.x, b.low.y - a.high.y}, {b.high.x - a.low.x, b.high.y - a.low.y}};
}

// Adds B_j + (-A_i): one half-plane for each edge of either.
void add_difference(const SlicePiece& a, const SlicePiece& b, ObstacleSlice& slice);

enum class SliceUse : std::uint8_t {
  kValue,
  kBound,
};

struct SliceMinimum {
  Vec2 t;
  double value = 0.0;
  std::int32_t polygon = -1;  // whose edge t lies on; -1: the function's own minimum is free
};

// Why kBound holds: let x be the last point, on the way from an exactly free point straight to the
// origin, that is outside every open polygon. f does not grow on the way. If x is not the origin it
// is on an edge, and the nearest point x' on the edge's computed line is within e of x. Counted as
// covered, x' would lie deeper than 2 e, x deeper than e inside a polygon; so it is not, and
// whatever covers a point s of that line ends before x'. As f is convex on the line, the first
// uncovered point from its minimum on towards x' is no worse than x'.
//
// The least value below `cutoff` (finite) of f outside the obstacle, and where; nothing if there is
// none. The slice must hold every polygon that comes within f.reach(cutoff) of the origin.
// `origin_is_covered`: whoever knows that t = 0 is not free says so.
std::optional<SliceMinimum> least_outside(const ObstacleSlice& slice, const FarthestPoint& f,
                                          double cutoff, SliceUse use,
                                          bool origin_is_covered = false);

}  // namespace pdg
