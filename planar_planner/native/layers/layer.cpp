#include "layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planar_planner/native/world/pieces.hpp"

namespace planner {

namespace {

// A convex piece in the user's numbers.
struct GivenPiece {
  std::uint32_t polygon;
  std::uint32_t index;
  pdg::ConvexPolygon vertices;
};

bool meet(const Rectangle& a, const Rectangle& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

template <class Polygons>  // PolygonSet or Obstacles
std::vector<GivenPiece> partition(const Polygons& polygons,
                                  const std::optional<Rectangle>& near = std::nullopt) {
  std::vector<GivenPiece> out;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (near && !meet(*near, polygons.bounds(i))) continue;
    std::uint32_t index = 0;
    for (pdg::ConvexPolygon& piece : planner_pieces(polygons.polygon(i)))
      out.push_back({static_cast<std::uint32_t>(i), index++, std::move(piece)});
  }
  return out;
}

constexpr LatticePoint turned(LatticePoint p, const int quarters) {
  for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
  return p;
}

std::vector<LayerPiece> on_lattice(const Lattice& lattice, const std::vector<GivenPiece>& pieces,
                                   const int quarters) {
  std::vector<LayerPiece> out;
  out.reserve(pieces.size());
  for (const GivenPiece& piece : pieces) {
    LayerPiece& placed = out.emplace_back(LayerPiece{piece.polygon, piece.index, {}});
    for (const Vec2 p : piece.vertices)
      placed.vertices.push_back(turned(to_lattice(lattice, p), quarters));
  }
  return out;
}

void append(std::vector<double>& values, const Vec2 p) {
  values.push_back(p.x);
  values.push_back(p.y);
}

void append(std::vector<double>& values, const std::optional<Rectangle>& r) {
  if (!r) return;
  append(values, r->low);
  append(values, r->high);
}

std::optional<Rectangle> body_box(const Problem& problem) {
  if (!problem.workspace) return problem.box;
  PolygonSet outline;
  outline.append(*problem.workspace);
  return outline.bounds(0);
}

void keep_inside(LatticeRectangle& r, const LatticePoint low, const LatticePoint high) {
  r.low = {std::max(r.low.x, low.x), std::max(r.low.y, low.y)};
  r.high = {std::min(r.high.x, high.x), std::min(r.high.y, high.y)};
}

// The whole robot inside the box, and the reference point inside its own bounds.
LatticeRectangle make_domain(const Lattice& lattice, const std::optional<Rectangle>& box,
                             const std::optional<Rectangle>& reference,
                             const std::vector<LayerPiece>& robot) {
  constexpr auto far = static_cast<Int64>(std::uint64_t{1} << unsigned{kLatticeBits + 1});
  LatticeRectangle domain{{-far, -far}, {far, far}};
  if (reference)
    keep_inside(domain, to_lattice(lattice, reference->low), to_lattice(lattice, reference->high));
  if (box)
    for (const LayerPiece& piece : robot)
      for (const LatticePoint p : piece.vertices)
        keep_inside(domain, to_lattice(lattice, box->low) - p, to_lattice(lattice, box->high) - p);
  return domain;
}

double rounded_down(const Int64 v) {
  return std::nextafter(static_cast<double>(v), -std::numeric_limits<double>::infinity());
}
double rounded_up(const Int64 v) {
  return std::nextafter(static_cast<double>(v), std::numeric_limits<double>::infinity());
}

pdg::Box outer_box(const LatticePoint low, const LatticePoint high) {
  return {{rounded_down(low.x), rounded_down(low.y)}, {rounded_up(high.x), rounded_up(high.y)}};
}

std::size_t count_vertices(const std::vector<GivenPiece>& pieces) {
  std::size_t count = 0;
  for (const GivenPiece& piece : pieces) count += piece.vertices.size();
  return count;
}

bool is_within(const std::vector<GivenPiece>& robot, const std::vector<GivenPiece>& obstacles,
               const LayerLimits& limits) {
  const std::size_t vertices =
      count_vertices(robot) * obstacles.size() + count_vertices(obstacles) * robot.size();
  return robot.size() * obstacles.size() <= limits.sums && vertices <= limits.vertices;
}

std::optional<Lattice> lattice_of(const Problem& problem, const LayerQuery& query,
                                  const std::vector<GivenPiece>& robot,
                                  const std::vector<GivenPiece>& obstacles,
                                  const std::vector<GivenPiece>& region) {
  std::vector<double> values;
  for (const std::vector<GivenPiece>* const pieces : {&robot, &obstacles, &region})
    for (const GivenPiece& piece : *pieces)
      for (const Vec2 p : piece.vertices) append(values, p);
  append(values, body_box(problem));
  append(values, problem.reference_bounds);
  append(values, query.start);
  append(values, query.goal);
  values.push_back(query.finest);
  return common_lattice(values);
}

void add_sums(Layer& layer) {
  std::vector<pdg::Box> boxes;
  for (std::size_t o = 0; o < layer.obstacles.size(); ++o)
    for (std::size_t r = 0; r < layer.robot.size(); ++r) {
      OpenSum& sum = layer.sums.emplace_back(
          make_open_sum(layer.obstacles[o].vertices, layer.robot[r].vertices));
      sum.obstacle_piece = static_cast<std::uint32_t>(o);
      sum.robot_piece = static_cast<std::uint32_t>(r);
      boxes.push_back(outer_box(sum.low, sum.high));
    }
  if (!boxes.empty()) layer.tree = pdg::build_box_tree(boxes);
}

}  // namespace

std::optional<Layer> make_layer(const ScaledProblem& problem, const LayerQuery& query,
                                const LayerLimits& limits) {
  const std::vector<GivenPiece> robot = partition(problem.given.robot);
  const std::vector<GivenPiece> obstacles = partition(all_obstacles(problem), query.near);
  if (!is_within(robot, obstacles, limits)) return std::nullopt;
  const std::vector<GivenPiece> region =
      query.region == nullptr ? std::vector<GivenPiece>{} : partition(*query.region);
  const std::optional<Lattice> lattice = lattice_of(problem.given, query, robot, obstacles, region);
  if (!lattice) return std::nullopt;
  Layer layer;
  layer.lattice = *lattice;
  layer.robot = on_lattice(*lattice, robot, query.quarters);
  layer.obstacles = on_lattice(*lattice, obstacles, 0);
  layer.domain =
      make_domain(*lattice, body_box(problem.given), problem.given.reference_bounds, layer.robot);
  layer.start = to_lattice(*lattice, query.start);
  layer.goal = to_lattice(*lattice, query.goal);
  for (LayerPiece& piece : on_lattice(*lattice, region, 0))
    layer.region.push_back(std::move(piece.vertices));
  add_sums(layer);
  return layer;
}

std::optional<Overlap> deepest_overlap(const Layer& layer, const LatticePoint p) {
  std::optional<Overlap> deepest;
  for (std::size_t i = 0; i < layer.sums.size(); ++i) {
    const std::vector<LatticePoint>& ring = layer.sums[i].vertices;
    if (!contains(layer.sums[i], p)) continue;
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const LatticePoint a = ring[k];
      const LatticePoint b = ring[(k + 1) % ring.size()];
      const double length =
          std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
      depth = std::min(depth, static_cast<double>(orientation(a, b, p)) / length);
    }
    depth = std::ldexp(depth, layer.lattice.exponent);
    if (!deepest || depth > deepest->depth) deepest = Overlap{i, depth};
  }
  return deepest;
}

bool in_region(const Layer& layer, const LatticePoint p) {
  return std::any_of(layer.region.begin(), layer.region.end(), [&](const LatticePolygon& piece) {
    for (std::size_t k = 0; k < piece.size(); ++k)
      if (orientation(piece[k], piece[(k + 1) % piece.size()], p) < 0) return false;
    return true;
  });
}

void find_near(const Layer& layer, const LatticePoint a, const LatticePoint b,
               std::vector<std::int32_t>& found) {
  found.clear();
  if (layer.sums.empty()) return;
  pdg::find_meeting(
      layer.tree,
      outer_box({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}),
      found);
}

bool is_free(const Layer& layer, const LatticePoint p, std::vector<std::int32_t>& scratch) {
  if (!contains(layer.domain, p)) return false;
  find_near(layer, p, p, scratch);
  return std::none_of(scratch.begin(), scratch.end(), [&](const std::int32_t i) {
    return contains(layer.sums[static_cast<std::size_t>(i)], p);
  });
}

bool is_free(const Layer& layer, const LatticePoint a, const LatticePoint b,
             std::vector<std::int32_t>& scratch) {
  find_near(layer, a, b, scratch);
  return std::none_of(scratch.begin(), scratch.end(), [&](const std::int32_t i) {
    return meets_segment(layer.sums[static_cast<std::size_t>(i)], a, b);
  });
}

}  // namespace planner
