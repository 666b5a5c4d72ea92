#include "open_sum.hpp"

#include <algorithm>
#include <cstddef>

namespace planner {

namespace {

std::size_t next(const std::size_t i, const LatticePolygon& polygon) {
  return i + 1 == polygon.size() ? 0 : i + 1;
}

// The lowest vertex, the leftmost one of two.
std::size_t first_vertex(const LatticePolygon& polygon) {
  const auto lower = [](const LatticePoint a, const LatticePoint b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  };
  return static_cast<std::size_t>(std::min_element(polygon.begin(), polygon.end(), lower) -
                                  polygon.begin());
}

LatticePolygon mirrored(LatticePolygon polygon) {
  for (LatticePoint& p : polygon) p = {-p.x, -p.y};
  return polygon;
}

// Is one of `polygon`'s edges a line that has all of `others` on its outer side or on itself?
bool edge_separates(const LatticePolygon& polygon, const LatticePolygon& others) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LatticePoint a = polygon[i];
    const LatticePoint b = polygon[next(i, polygon)];
    const auto outside = [&](const LatticePoint p) { return orientation(a, b, p) <= 0; };
    if (std::all_of(others.begin(), others.end(), outside)) return true;
  }
  return false;
}

// The point (x, y / w) with w > 0.
struct CutPoint {
  Int64 x;
  Int128 y;
  Int64 w;
};

// Where the polygon's outline crosses the vertical line, at edges that pass from one side to the
// other.
std::vector<CutPoint> cut_points(const LatticePolygon& polygon, const Int64 x) {
  std::vector<CutPoint> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    LatticePoint a = polygon[i];
    LatticePoint b = polygon[next(i, polygon)];
    if (a.x > b.x) std::swap(a, b);
    if (a.x >= x || b.x <= x) continue;
    const Int64 w = b.x - a.x;
    points.push_back(
        {x, static_cast<Int128>(a.y) * w + static_cast<Int128>(b.y - a.y) * (x - a.x), w});
  }
  return points;
}

// Is the cut point on the outer side of the line from a to b, or on it?
bool is_outside(const LatticePoint a, const LatticePoint b, const CutPoint& p) {
  const LatticePoint d = b - a;
  return compare_products(d.x, p.y - static_cast<Int128>(a.y) * p.w, d.y,
                          static_cast<Int128>(p.x - a.x) * p.w) <= 0;
}

// The part of a convex polygon right of a vertical line.
struct RightPart {
  LatticePolygon corners;
  std::vector<CutPoint> cuts;
};

RightPart right_part(const LatticePolygon& polygon, const Int64 x) {
  RightPart part{{}, cut_points(polygon, x)};
  for (const LatticePoint p : polygon)
    if (p.x >= x) part.corners.push_back(p);
  return part;
}

bool edge_separates(const LatticePolygon& polygon, const RightPart& others) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LatticePoint a = polygon[i];
    const LatticePoint b = polygon[next(i, polygon)];
    const auto outside = [&](const LatticePoint p) { return orientation(a, b, p) <= 0; };
    const auto cut_outside = [&](const CutPoint& p) { return is_outside(a, b, p); };
    if (std::all_of(others.corners.begin(), others.corners.end(), outside) &&
        std::all_of(others.cuts.begin(), others.cuts.end(), cut_outside))
      return true;
  }
  return false;
}

}  // namespace

LatticePolygon convex_sum(const LatticePolygon& obstacle, const LatticePolygon& robot) {
  const LatticePolygon minus = mirrored(robot);
  LatticePolygon sum;
  std::size_t i = first_vertex(obstacle);
  std::size_t j = first_vertex(minus);
  std::size_t left_i = obstacle.size();
  std::size_t left_j = minus.size();
  // Edges of both in the order of their directions; parallel ones become one edge.
  while (left_i > 0 || left_j > 0) {
    sum.push_back(obstacle[i] + minus[j]);
    const LatticePoint edge_i = obstacle[next(i, obstacle)] - obstacle[i];
    const LatticePoint edge_j = minus[next(j, minus)] - minus[j];
    const Int128 turn = left_i == 0 ? -1 : left_j == 0 ? 1 : cross(edge_i, edge_j);
    if (turn >= 0) {
      i = next(i, obstacle);
      --left_i;
    }
    if (turn <= 0) {
      j = next(j, minus);
      --left_j;
    }
  }
  return sum;
}

OpenSum make_open_sum(const LatticePolygon& obstacle, const LatticePolygon& robot) {
  OpenSum sum;
  sum.vertices = convex_sum(obstacle, robot);
  sum.low = sum.high = sum.vertices.front();
  for (const LatticePoint p : sum.vertices) {
    sum.low = {std::min(sum.low.x, p.x), std::min(sum.low.y, p.y)};
    sum.high = {std::max(sum.high.x, p.x), std::max(sum.high.y, p.y)};
  }
  return sum;
}

bool contains(const OpenSum& sum, const LatticePoint p) {
  if (p.x <= sum.low.x || p.x >= sum.high.x || p.y <= sum.low.y || p.y >= sum.high.y) return false;
  for (std::size_t i = 0; i < sum.vertices.size(); ++i)
    if (orientation(sum.vertices[i], sum.vertices[next(i, sum.vertices)], p) <= 0) return false;
  return true;
}

// Two convex sets are apart iff an edge of one separates them; of a segment that is its own line.
bool meets_segment(const OpenSum& sum, const LatticePoint a, const LatticePoint b) {
  if (std::max(a.x, b.x) <= sum.low.x || std::min(a.x, b.x) >= sum.high.x ||
      std::max(a.y, b.y) <= sum.low.y || std::min(a.y, b.y) >= sum.high.y)
    return false;
  bool left = false;
  bool right = false;
  for (const LatticePoint p : sum.vertices) {
    const Int128 side = orientation(a, b, p);
    left = left || side > 0;
    right = right || side < 0;
  }
  if (a != b && !(left && right)) return false;
  return !edge_separates(sum.vertices, LatticePolygon{a, b});
}

bool overlap(const OpenSum& sum, const LatticePolygon& polygon) {
  return !edge_separates(sum.vertices, polygon) && !edge_separates(polygon, sum.vertices);
}

bool overlap(const OpenSum& a, const OpenSum& b) {
  if (a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y || b.high.y <= a.low.y)
    return false;
  return !edge_separates(a.vertices, b.vertices) && !edge_separates(b.vertices, a.vertices);
}

// The part of `a` right of the line is convex: its edges lie on edges of `a` or on the line.
bool overlap_right_of(const OpenSum& a, const OpenSum& b, const Int64 x) {
  if (a.high.x <= x || b.high.x <= x) return false;
  if (a.low.x >= x || b.low.x >= x) return overlap(a, b);
  const RightPart right_a = right_part(a.vertices, x);
  const RightPart right_b = right_part(b.vertices, x);
  return !edge_separates(b.vertices, right_a) && !edge_separates(a.vertices, right_b);
}

Slice slice_at(const OpenSum& sum, const LatticePoint p) {
  if (p.x <= sum.low.x || p.x >= sum.high.x) return Slice::kNone;
  // p lies outside: it is above the slice iff it is above an edge of the upper chain or on one.
  for (std::size_t i = 0; i < sum.vertices.size(); ++i) {
    const LatticePoint a = sum.vertices[i];
    const LatticePoint b = sum.vertices[next(i, sum.vertices)];
    if (b.x < a.x && b.x <= p.x && p.x <= a.x && orientation(a, b, p) <= 0) return Slice::kBelow;
  }
  return Slice::kAbove;
}

}  // namespace planner
