// The problem as handed over by the caller: validated, in the user's units, nothing rounded.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "pdg/native/geometry/polygon.hpp"

namespace planner {

using pdg::Polygon;
using pdg::Vec2;

struct Rectangle {
  Vec2 low;
  Vec2 high;
};

// Polygons in flat arrays: ring r is points[ring_starts[r] .. ring_starts[r + 1]), polygon p has
// rings polygon_starts[p] .. polygon_starts[p + 1), the outer one first.
struct PolygonSet {
  std::vector<Vec2> points;
  std::vector<std::uint32_t> ring_starts{0};
  std::vector<std::uint32_t> polygon_starts{0};

  [[nodiscard]] std::size_t size() const { return polygon_starts.size() - 1; }
  [[nodiscard]] Polygon polygon(std::size_t index) const;
  [[nodiscard]] Rectangle bounds(std::size_t index) const;
  [[nodiscard]] std::span<const Vec2> outer_ring(std::size_t index) const;
  void append(const Polygon& polygon);
};

// Obstacle polygons, numbered through: those that are given, then those that stand for what lies
// outside a polygonal workspace. Both sets must outlive this.
class Obstacles {
 public:
  Obstacles(const PolygonSet& given, const PolygonSet& outside)
      : given_(&given), outside_(&outside) {}

  [[nodiscard]] std::size_t size() const { return given_->size() + outside_->size(); }
  [[nodiscard]] std::size_t points() const {
    return given_->points.size() + outside_->points.size();
  }
  [[nodiscard]] Polygon polygon(const std::size_t index) const {
    return set_of(index).polygon(place_of(index));
  }
  [[nodiscard]] Rectangle bounds(const std::size_t index) const {
    return set_of(index).bounds(place_of(index));
  }
  [[nodiscard]] std::span<const Vec2> outer_ring(const std::size_t index) const {
    return set_of(index).outer_ring(place_of(index));
  }

 private:
  [[nodiscard]] const PolygonSet& set_of(const std::size_t index) const {
    return index < given_->size() ? *given_ : *outside_;
  }
  [[nodiscard]] std::size_t place_of(const std::size_t index) const {
    return index < given_->size() ? index : index - given_->size();
  }

  const PolygonSet* given_;
  const PolygonSet* outside_;
};

struct Problem {
  PolygonSet robot;                           // robot frame
  PolygonSet obstacles;                       // world frame
  std::optional<Rectangle> box;               // the whole robot stays inside
  std::optional<Polygon> workspace;           // the whole robot stays inside
  std::optional<Rectangle> reference_bounds;  // the reference point stays inside
  bool rotation = true;                       // false: theta stays at the start's
};

// theta in radians, unwrapped.
struct Configuration {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
};

// Every configuration whose reference point lies in the closed polygons (world frame) and whose
// theta lies in the closed interval, up to whole turns.
struct GoalSet {
  PolygonSet polygons;
  struct Angles {
    double low, high;  // radians, low <= high < low + 2 pi
  };
  std::optional<Angles> angles;  // empty: any
};

using Goal = std::variant<Configuration, GoalSet>;

}  // namespace planner
