#include "c_obstacle_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "pdg/native/tolerances.hpp"
#include "separation.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

// One stretch of orientations with the whole rectangle of translations.
struct Stretch {
  Rotation rotation;
  Motion motion;
};

Stretch make_stretch(const Pose& centre, const HalfExtents& half) {
  const double reach =
      (std::hypot(centre.t.x, centre.t.y) + std::hypot(half.x, half.y)) * kRadiusPadding;
  return {rotation_of(centre.theta),
          make_motion(centre.t, {half.x, 0.0}, {0.0, half.y}, half_angle_of(half.theta), reach)};
}

// Stretches that together cover the cell. Their centres are rounded, so each is widened by that.
std::vector<Stretch> cover(const Cell& cell) {
  const double half = std::min(cell.half.theta, std::numbers::pi * kRadiusPadding);
  if (half <= kWidestTurn) return {make_stretch(cell.centre, cell.half)};
  const double rounding = kStretchUnits * kUnitRoundoff * (std::abs(cell.centre.theta) + half);
  // An angle so large that its sums are no angles any more: every orientation, about 0 instead.
  if (rounding > kLargestWidening)
    return cover(
        {{cell.centre.t, 0.0}, {cell.half.x, cell.half.y, std::numbers::pi * kRadiusPadding}});
  const auto count = static_cast<int>(std::ceil(half / kWidestTurn));
  const double part = half / count;
  std::vector<Stretch> stretches;
  for (int i = 0; i < count; ++i) {
    const double offset = (2 * i + 1 - count) * part;
    stretches.push_back(make_stretch({cell.centre.t, cell.centre.theta + offset},
                                     {cell.half.x, cell.half.y, part + rounding}));
  }
  return stretches;
}

// Certified lower bound of PD^t(A_i(q), B_j) over the whole stretch; negative proves nothing.
double depth_over(const ConvexPiece& a, const ConvexPiece& b, const Stretch& stretch) {
  std::vector<Vec2> vertices;
  std::vector<Vec2> normals;
  for (const Edge& edge : a.edges) {
    vertices.push_back(rotate(stretch.rotation, edge.vertex));
    normals.push_back(rotate(stretch.rotation, edge.normal));
  }
  const PosedPiece posed{&a, vertices, normals, rotate(stretch.rotation, a.inner_centre)};
  const double error = separation_error(a, b, stretch.motion);
  std::vector<Constraint> constraints;
  all_constraints(a, b, constraints);
  double highest = -std::numeric_limits<double>::infinity();
  for (Constraint& c : constraints) {
    const double hi = constraint_range(posed, b, stretch.motion, error, c).hi;
    if (!(hi <= highest)) highest = hi;  // a NaN must not pass for a small value
  }
  return -highest - error;
}

// Lower bound less motion: one more rounding, taken downwards.
double difference_down(const double depth, const double motion) {
  return depth - motion - kUnitRoundoff * (std::abs(depth) + motion);
}

}  // namespace

CObstacleVerdict c_obstacle_query(const PieceSet& a, const PieceSet& b, const Cell& cell,
                                  const QueryMethod method) {
  const Stretch centre = make_stretch(cell.centre, {});
  const std::vector<Stretch> whole =
      method == QueryMethod::kPerNormal ? cover(cell) : std::vector<Stretch>{};
  const auto margin_of = [&](const std::size_t i, const std::size_t j) {
    const ConvexPiece& piece_a = a.pieces[i];
    const ConvexPiece& piece_b = b.pieces[j];
    if (method == QueryMethod::kPerNormal) {
      double least = std::numeric_limits<double>::infinity();
      for (const Stretch& s : whole) least = std::min(least, depth_over(piece_a, piece_b, s));
      return least;
    }
    const double bound = method == QueryMethod::kPublished
                             ? sum_bound(cell.half, a.radius)
                             : displacement_bound(cell.half, a.radii[i]);
    return difference_down(depth_over(piece_a, piece_b, centre), bound);
  };
  CObstacleVerdict verdict;
  verdict.margin = -std::numeric_limits<double>::infinity();
  std::vector<std::int32_t> near;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    // A pair that overlaps everywhere overlaps at the centre, so disjoint boxes there rule it out.
    near.clear();
    find_meeting(b.tree, bounding_box(placed(a.polygons[i], cell.centre)), near);
    std::sort(near.begin(), near.end());
    for (const std::int32_t j : near) {
      const double margin = margin_of(i, static_cast<std::size_t>(j));
      if (verdict.piece_a >= 0 && !(margin > verdict.margin)) continue;
      verdict = {margin > 0.0, static_cast<int>(i), j, margin};
    }
  }
  return verdict;
}

}  // namespace pdg
