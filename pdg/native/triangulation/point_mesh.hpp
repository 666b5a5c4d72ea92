// A triangulation of a point set as arrays of half-edges, with edge flips.
//
// Notation: half-edges 3t, 3t + 1, 3t + 2 bound triangle t counter-clockwise; each starts at
// origin[h] and ends at the origin of the next. All decisions use exact predicates only.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "pdg/native/geometry/vec.hpp"
#include "tuning.hpp"

namespace pdg {

using Index = std::int32_t;
inline constexpr Index kNone = -1;

inline constexpr double kUnmeasured = -1.0;

struct PointMesh {
  std::vector<Vec2> points;         // distinct, sorted lexicographically
  std::vector<Index> origin;        // per half-edge: point
  std::vector<Index> twin;          // per half-edge: opposite half-edge, kNone on the hull
  std::vector<std::uint8_t> fixed;  // per half-edge: part of a constraint, never flipped
  std::vector<std::uint8_t> odd;    // per half-edge: covered by an odd number of constraints
  std::vector<Index> outgoing;      // per point: one half-edge that starts there, or kNone
  std::vector<Index> hull_edge;     // per hull point: the hull half-edge that starts there
  std::vector<double> least_sine;   // per triangle: of its least angle, or kUnmeasured
  std::uint64_t steps = 0;          // work spent on constraints
  std::uint64_t most_steps = kMostConstraintSteps;

  static constexpr Index next(const Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static constexpr Index prev(const Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index from(const Index h) const { return origin[at(h)]; }
  Index to(const Index h) const { return origin[at(next(h))]; }
  Index opposite(const Index h) const { return twin[at(h)]; }
  Vec2 point(const Index v) const { return points[at(v)]; }
  Index triangle_count() const { return static_cast<Index>(origin.size() / 3); }

  static constexpr std::size_t at(const Index i) { return static_cast<std::size_t>(i); }
};

// Makes a and b opposite; b may be kNone.
void link(PointMesh& mesh, Index a, Index b);

// Appends the counter-clockwise triangle (a, b, c), linked to nothing; returns its half-edge a ->
// b.
Index add_triangle(PointMesh& mesh, Index a, Index b, Index c);

// Lets the half-edge h start at the point v instead.
void replace_corner(PointMesh& mesh, Index h, Index v);

// First half-edge of v in counter-clockwise order: the hull's one when v is on the hull.
Index first_outgoing(const PointMesh& mesh, Index v);

// The next half-edge of the same origin, counter-clockwise; kNone past the hull.
Index rotate_ccw(const PointMesh& mesh, Index h);

// The half-edge a -> b, or the one b -> a when a -> b is outside the hull, or kNone.
Index find_edge(const PointMesh& mesh, Index a, Index b);

// Whether the two triangles at h form a strictly convex quadrilateral (exact) and h is not fixed.
bool can_flip(const PointMesh& mesh, Index h);

// Replaces the edge of h by the other diagonal of its quadrilateral. Requires can_flip.
void flip(PointMesh& mesh, Index h);

// Flips every flippable edge reachable from the given ones while that enlarges the smaller of the
// two triangles' least angles, up to a number of flips; takes the edges out of the list. Always
// ends: see the comment at the definition.
void improve_angles(PointMesh& mesh, std::vector<Index>& half_edges,
                    std::uint64_t most_flips = std::numeric_limits<std::uint64_t>::max());

}  // namespace pdg
