// Random scenes for the planner's tests, and a slow oracle for them in long double: the signed
// separation of a configuration, from the scene's own doubles, by separating axes of convex pairs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "pdg/native/pieces/decompose.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/labels/label.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "random_polygons.hpp"

namespace worlds {

using fuzz::pick;
using fuzz::Random;
using pdg::Vec2;
using Real = long double;

inline double uniform(Random& random, const double low, const double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// What the scene may contain; every world is made from a seed and one of these.
struct Recipe {
  int robot_polygons = 1;
  int obstacles = 3;
  bool convex = true;   // of robot and obstacles; otherwise simple polygons
  double sliver = 1.0;  // least aspect ratio of a shape
  double robot_size = 1.0;
  double obstacle_size = 2.0;
  double off_body = 0.0;  // distance of the robot's origin from its shapes
  double far = 0.0;       // distance of the scene from the user's origin
  bool rotation = true;
};

// Convex: random points of an ellipse, in order. Otherwise a simple polygon.
inline pdg::Polygon random_shape(Random& random, const Recipe& recipe, const double size,
                                 const Vec2 centre) {
  const double turn = uniform(random, 0.0, 2.0 * std::numbers::pi);
  const double aspect = std::exp(uniform(random, std::log(recipe.sliver), 0.0));
  const auto place = [&](const Vec2 p) {
    const Vec2 q{size * p.x, size * aspect * p.y};
    return Vec2{centre.x + std::cos(turn) * q.x - std::sin(turn) * q.y,
                centre.y + std::sin(turn) * q.x + std::cos(turn) * q.y};
  };
  pdg::Ring ring;
  if (recipe.convex) {
    const int count = pick(random, 3, 9);
    const double phase = uniform(random, 0.0, 6.0);
    for (int i = 0; i < count; ++i) {
      const double angle = phase + (i + uniform(random, 0.0, 0.8)) * 2.0 * std::numbers::pi / count;
      ring.push_back(place({std::cos(angle), std::sin(angle)}));
    }
  } else {
    const pdg::Ring simple = fuzz::random_simple(random, pick(random, 5, 11), 8).polygon.rings[0];
    for (const Vec2 p : simple) ring.push_back(place({p.x / 8.0, p.y / 8.0}));
  }
  return {{std::move(ring)}};
}

inline planner::Problem random_scene(Random& random, const Recipe& recipe) {
  planner::Problem scene;
  const double far_angle = uniform(random, 0.0, 6.0);
  const Vec2 origin{recipe.far * std::cos(far_angle), recipe.far * std::sin(far_angle)};
  const double off_angle = uniform(random, 0.0, 6.0);
  const Vec2 off{recipe.off_body * std::cos(off_angle), recipe.off_body * std::sin(off_angle)};
  for (int i = 0; i < recipe.robot_polygons; ++i) {
    const double spread = recipe.robot_polygons > 1 ? recipe.robot_size : 0.3 * recipe.robot_size;
    const Vec2 centre{uniform(random, -spread, spread), uniform(random, -spread, spread)};
    scene.robot.append(random_shape(random, recipe, recipe.robot_size, off + centre));
  }
  const Vec2 half{uniform(random, 4.0, 6.0), uniform(random, 4.0, 6.0)};
  scene.box = planner::Rectangle{origin - half, origin + half};
  for (int i = 0; i < recipe.obstacles; ++i) {
    const Vec2 centre{uniform(random, -half.x, half.x), uniform(random, -half.y, half.y)};
    const double size = recipe.obstacle_size * uniform(random, 0.3, 1.0);
    scene.obstacles.append(random_shape(random, recipe, size, origin + centre));
  }
  scene.rotation = recipe.rotation;
  return scene;
}

inline std::vector<Recipe> recipes() {
  return {
      {},
      {.obstacles = 1, .robot_size = 0.1, .obstacle_size = 5.0},
      {.obstacles = 4, .robot_size = 3.0, .obstacle_size = 0.1},
      {.obstacles = 4, .sliver = 1e-3},
      {.robot_polygons = 3, .obstacles = 5, .robot_size = 0.7, .obstacle_size = 1.5},
      {.obstacles = 3, .convex = false, .obstacle_size = 3.0},
      {.robot_polygons = 2, .obstacles = 3, .convex = false, .off_body = 2.0},
      {.obstacles = 3, .off_body = 9.0, .far = 1e5},
      {.obstacles = 4, .far = 1e7},
  };
}

// A configuration in planner units; theta in radians.
struct Point {
  Real x, y, theta;
};

inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y, a.theta + b.theta};
}
inline Point operator*(const Real s, const Point& a) {
  return {s * a.x, s * a.y, s * a.theta};
}
inline Point operator-(const Point& a, const Point& b) {
  return a + Real{-1} * b;
}

struct RealVec {
  Real x, y;
};
using RealRing = std::vector<RealVec>;

inline constexpr Real kFullTurn = 2.0L * std::numbers::pi_v<Real>;

// Largest over the edges of `edges` of the least signed distance of `others` beyond it.
inline Real edge_separation(const RealRing& edges, const RealRing& others) {
  Real best = -INFINITY;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const RealVec p = edges[i];
    const RealVec q = edges[(i + 1) % edges.size()];
    const Real length = std::hypot(q.x - p.x, q.y - p.y);
    const RealVec n{(q.y - p.y) / length, (p.x - q.x) / length};
    Real least = INFINITY;
    for (const RealVec r : others) least = std::min(least, n.x * (r.x - p.x) + n.y * (r.y - p.y));
    best = std::max(best, least);
  }
  return best;
}

inline Real edge_distance(const RealRing& edges, const RealRing& points) {
  Real best = INFINITY;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const RealVec p = edges[i];
    const RealVec q = edges[(i + 1) % edges.size()];
    const RealVec d{q.x - p.x, q.y - p.y};
    for (const RealVec r : points) {
      const Real s =
          std::clamp<Real>(((r.x - p.x) * d.x + (r.y - p.y) * d.y) / (d.x * d.x + d.y * d.y), 0, 1);
      best = std::min(best, std::hypot(p.x + s * d.x - r.x, p.y + s * d.y - r.y));
    }
  }
  return best;
}

// Separation of convex pieces by axes, independent of the core's arithmetic: > 0 apart, < 0
// overlap.
class Oracle {
 public:
  explicit Oracle(const planner::ScaledProblem& problem) : frame_(problem.frame) {
    const auto add = [&](const auto& set, const pdg::Frame& frame, std::vector<RealRing>& out) {
      for (std::size_t i = 0; i < set.size(); ++i)
        for (const pdg::ConvexPolygon& piece : pdg::convex_partition(set.polygon(i)))
          out.push_back(framed(piece, frame));
    };
    add(problem.given.robot, {{}, frame_.exponent}, robot_);
    add(all_obstacles(problem), frame_, obstacles_);
    if (problem.given.box) {
      low_ = framed(problem.given.box->low, frame_);
      high_ = framed(problem.given.box->high, frame_);
      walled_ = true;
    }
  }

  [[nodiscard]] static RealVec framed(const Vec2 p, const pdg::Frame& frame) {
    return {std::ldexp(static_cast<Real>(p.x) - frame.origin.x, frame.exponent),
            std::ldexp(static_cast<Real>(p.y) - frame.origin.y, frame.exponent)};
  }

  // Least over pairs and walls; its sign says free or not.
  [[nodiscard]] Real separation(const Point& q) const {
    return least(q, [](const RealRing& obstacle, const RealRing& placed) {
      return std::max(edge_separation(obstacle, placed), edge_separation(placed, obstacle));
    });
  }

  // Euclidean distance to the nearest obstacle or wall; the configuration is free.
  [[nodiscard]] Real distance(const Point& q) const {
    return least(q, [](const RealRing& obstacle, const RealRing& placed) {
      return std::min(edge_distance(obstacle, placed), edge_distance(placed, obstacle));
    });
  }

 private:
  template <class Of>
  [[nodiscard]] Real least(const Point& q, const Of& of) const {
    const Real c = std::cos(q.theta);
    const Real s = std::sin(q.theta);
    Real least = INFINITY;
    for (const RealRing& piece : robot_) {
      RealRing placed;
      for (const RealVec a : piece)
        placed.push_back({c * a.x - s * a.y + q.x, s * a.x + c * a.y + q.y});
      for (const RealRing& obstacle : obstacles_) least = std::min(least, of(obstacle, placed));
      if (!walled_) continue;
      for (const RealVec p : placed)
        least = std::min({least, p.x - low_.x, high_.x - p.x, p.y - low_.y, high_.y - p.y});
    }
    return least;
  }

  static RealRing framed(const pdg::ConvexPolygon& polygon, const pdg::Frame& frame) {
    RealRing out;
    for (const Vec2 p : polygon) out.push_back(framed(p, frame));
    return out;
  }

  pdg::Frame frame_;
  std::vector<RealRing> robot_, obstacles_;
  RealVec low_{}, high_{};
  bool walled_ = false;
};

// The parts of a planner, put together by hand.
struct World {
  explicit World(planner::Problem scene, const double theta = 0.0)
      : problem(planner::make_scaled_problem(std::move(scene))),
        tree(all_obstacles(problem), problem.frame, problem.walls),
        labeller(problem.robot, tree, statistics),
        posed(problem.robot),
        oracle(problem),
        space{problem.domain, problem.rotation, theta} {}
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // The robot at a rotation, until the next call.
  planner::PosedRobot& posed_at(const pdg::Rotation rotation) {
    posed.turn_to(rotation);
    return posed;
  }

  planner::ScaledProblem problem;
  planner::ObstacleTree tree;
  planner::Statistics statistics;
  planner::Labeller labeller;
  planner::PosedRobot posed;
  Oracle oracle;
  planner::CellSpace space;
};

// A closed box of configurations with its corners.
struct Box {
  Point low, size;

  [[nodiscard]] Point at(const Real a, const Real b, const Real c) const {
    return {low.x + a * size.x, low.y + b * size.y, low.theta + c * size.theta};
  }
};

inline Box box_of(const planner::CellSpace& space, const planner::Extent& e) {
  const auto fraction = [](const std::uint64_t k) {
    return std::ldexp(static_cast<Real>(k), -static_cast<int>(planner::kCoordinateBits));
  };
  const planner::Domain& d = space.domain;
  const Real theta = space.rotation ? kFullTurn * fraction(e.low[2]) : Real{space.fixed_theta};
  return {{d.low.x + d.size.x * fraction(e.low[0]), d.low.y + d.size.y * fraction(e.low[1]), theta},
          {d.size.x * fraction(e.size[0]), d.size.y * fraction(e.size[1]),
           space.rotation ? kFullTurn * fraction(e.size[2]) : Real{0}}};
}

// A point of the closed box: inside, or on a face, an edge or a corner of it.
inline std::array<Real, 3> random_place(Random& random) {
  std::array<Real, 3> place{};
  for (Real& x : place) {
    const int side = pick(random, 0, 5);
    x = side == 0 ? Real{0} : side == 1 ? Real{1} : static_cast<Real>(uniform(random, 0.0, 1.0));
  }
  return place;
}

// Pattern search for the least value of `value` over the closed box, from random places.
inline Real least_in(Random& random, const Box& box, const int starts,
                     const std::function<Real(const Point&)>& value) {
  Real least = INFINITY;
  for (int i = 0; i < starts; ++i) {
    std::array<Real, 3> place = random_place(random);
    Real here = value(box.at(place[0], place[1], place[2]));
    for (Real step = 0.25; step > 1e-3; step /= 2) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Real sign : {-1.0L, 1.0L}) {
          std::array<Real, 3> next = place;
          next[axis] = std::clamp<Real>(place[axis] + sign * step, 0, 1);
          const Real there = value(box.at(next[0], next[1], next[2]));
          if (there < here) {
            here = there;
            place = next;
          }
        }
    }
    least = std::min(least, here);
  }
  return least;
}

// A dyadic box of random place and levels; flat along some axes if asked for.
inline planner::Extent random_extent(Random& random, const bool rotation, const bool flat,
                                     const int deepest) {
  planner::Extent e;
  for (std::size_t k = 0; k < 3; ++k) {
    const int level = pick(random, k == 2 ? 2 : 0, deepest);
    e.size[k] = planner::kUnit >> level;
    const auto cells = std::uint64_t{1} << level;
    e.low[k] = e.size[k] * std::uniform_int_distribution<std::uint64_t>(0, cells - 1)(random);
    if (pick(random, 0, 9) == 0)
      e.low[k] = planner::kUnit - e.size[k];  // the domain's end, the seam
    if (flat && pick(random, 0, 2) == 0) e.size[k] = 0;
  }
  if (!rotation) e.low[2] = e.size[2] = 0;
  return e;
}

}  // namespace worlds
