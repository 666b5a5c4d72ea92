// Each claim where it is only just made: motions scaled up to the largest size at which a label,
// an obstruction by several pairs or a guard still holds. There a missing second-order term shows.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "planar_planner/native/labels/classify.hpp"
#include "planar_planner/native/labels/star.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "planner_worlds.hpp"

namespace {

using pdg::EdgeOwner;
using planner::ConstraintList;
using planner::Label;
using worlds::Random;
using worlds::Real;
using worlds::World;

struct Shape {
  pdg::Vec2 t;
  double theta;
  double x, y, turn;  // half-extents at scale 1
};

Shape random_shape(Random& random, const World& world) {
  const planner::Domain& d = world.problem.domain;
  const auto extent = [&] {
    return worlds::pick(random, 0, 4) == 0 ? 0.0 : std::exp(worlds::uniform(random, -3.0, 0.0));
  };
  Shape shape{{d.low.x + d.size.x * worlds::uniform(random, 0.1, 0.9),
               d.low.y + d.size.y * worlds::uniform(random, 0.1, 0.9)},
              worlds::uniform(random, -3.0, 3.0),
              0.5 * extent(),
              0.5 * extent(),
              0.7 * extent()};
  shape.x += 1e-3;
  return shape;
}

pdg::Motion motion_of(const World& world, const Shape& shape, const double scale) {
  pdg::Motion m = pdg::make_motion(shape.t, {scale * shape.x, 0.0}, {0.0, scale * shape.y},
                                   pdg::half_angle_of(std::min(scale * shape.turn, 0.78)),
                                   world.problem.domain.reach + 2.0);
  m.angle_error = planner::kPoseAngleUnits * pdg::kUnitRoundoff * std::abs(shape.theta);
  return m;
}

worlds::Box box_of(const pdg::Motion& m, const double theta) {
  const Real h = m.half_angle;
  return {{Real{m.t.x} - m.g1.x, Real{m.t.y} - m.g2.y, theta - h}, {2 * m.g1.x, 2 * m.g2.y, 2 * h}};
}

// What is claimed of a motion, from scratch.
struct Claims {
  Label label = Label::kMixed;
  bool joint = false;
  std::optional<pdg::Vec2> guard;
  ConstraintList list;
};

Claims claims_of(World& world, const Shape& shape, const double scale) {
  Claims out;
  ConstraintList root;
  world.labeller.root_list(root);
  const pdg::Motion m = motion_of(world, shape, scale);
  planner::PosedRobot& posed = world.posed_at({std::cos(shape.theta), std::sin(shape.theta)});
  planner::LabelResult result = world.labeller.label(m, posed, planner::view(root));
  out.label = result.label;
  out.list = std::move(result.undecided);
  if (out.label != Label::kMixed) return out;
  planner::Scratch scratch;
  planner::gather_terms(world.tree, m, posed, planner::view(out.list), scratch.terms);
  out.joint = planner::refute(scratch.terms, m, scratch.joint).has_value();
  out.guard = planner::find_guard(world.tree, m, posed, planner::view(out.list), scratch.star);
  return out;
}

// The largest scale found at which the claim holds; 0 if it does not at a small one.
double largest_scale(World& world, const Shape& shape,
                     const std::function<bool(const Claims&)>& holds) {
  double low = 0.0;
  for (const double start : {1.0, 0.3, 0.1, 0.03, 0.01})
    if (low == 0.0 && holds(claims_of(world, shape, start))) low = start;
  if (low == 0.0) return 0.0;
  double high = 2.0 * low;
  while (high < 4.0 && holds(claims_of(world, shape, high))) low = high, high *= 2.0;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(claims_of(world, shape, middle)) ? low : high) = middle;
  }
  return low;
}

// Near a contact from inside: the shallowest of some colliding configurations.
Shape shallow_shape(Random& random, const World& world) {
  Shape best = random_shape(random, world);
  Real shallowest = -INFINITY;
  for (int i = 0; i < 60; ++i) {
    const Shape shape = random_shape(random, world);
    const Real s = world.oracle.separation({shape.t.x, shape.t.y, shape.theta});
    if (s >= 0 || s <= shallowest) continue;
    shallowest = s;
    best = shape;
  }
  return best;
}

worlds::Recipe crowded(const std::uint64_t seed) {
  worlds::Recipe recipe = worlds::recipes()[seed % worlds::recipes().size()];
  recipe.obstacles += 6;
  return recipe;
}

// No sample contradicts the claim at the largest scale at which it is made; false if it never is.
bool holds_when_extremal(Random& random, World& world, const Shape& shape, const bool is_free,
                         const std::function<bool(const Claims&)>& claimed) {
  const double scale = largest_scale(world, shape, claimed);
  if (scale == 0.0) return false;
  const worlds::Box box = box_of(motion_of(world, shape, scale), shape.theta);
  const Real least = worlds::least_in(random, box, 4, [&](const worlds::Point& q) {
    const Real separation = world.oracle.separation(q);
    return is_free ? separation : -separation;
  });
  EXPECT_GT(least, 0.0L) << (is_free ? "FALSE FREE" : "FALSE FULL") << " at scale " << scale;
  return true;
}

TEST(PlannerExtremal, FreeAndFull) {
  int free = 0;
  int full = 0;
  for (std::uint64_t seed = 0; seed < 18; ++seed) {
    SCOPED_TRACE(seed);
    Random random(800 + seed);
    World world(worlds::random_scene(random, crowded(seed)));
    for (int i = 0; i < 25; ++i) {
      const Shape shape = random_shape(random, world);
      free += holds_when_extremal(random, world, shape, true,
                                  [](const Claims& c) { return c.label == Label::kFree; });
      full += holds_when_extremal(random, world, shape, false,
                                  [](const Claims& c) { return c.label == Label::kFull; });
    }
  }
  EXPECT_GT(free, 25);
  EXPECT_GT(full, 50);
}

TEST(PlannerExtremal, FullByPairsTogether) {
  int joint = 0;
  for (std::uint64_t seed = 0; seed < 90; ++seed) {
    SCOPED_TRACE(seed);
    Random random(1800 + seed);
    World world(worlds::random_scene(random, crowded(seed)));
    for (int i = 0; i < 12; ++i)
      joint += holds_when_extremal(random, world, shallow_shape(random, world), false,
                                   [](const Claims& c) { return c.joint; });
  }
  EXPECT_GT(joint, 20);
}

// One function s of a pair, for one vertex, with its gradient, in long double.
struct Function {
  const pdg::ConvexPiece& a;
  const pdg::ConvexPiece& b;
  const pdg::Constraint& c;
  std::size_t vertex;

  struct Value {
    Real s, dx, dy, dtheta;
  };

  [[nodiscard]] Value at(const worlds::Point& q) const {
    const Real cosine = std::cos(q.theta);
    const Real sine = std::sin(q.theta);
    if (c.owner == EdgeOwner::kObstacle) {
      const pdg::Edge& edge = b.edges[c.edge];
      const pdg::Vec2 v = a.edges[vertex].vertex;
      const Real x = cosine * v.x - sine * v.y;
      const Real y = sine * v.x + cosine * v.y;
      return {edge.normal.x * (x + q.x) + edge.normal.y * (y + q.y) - edge.offset, edge.normal.x,
              edge.normal.y, -edge.normal.x * y + edge.normal.y * x};
    }
    const pdg::Edge& edge = a.edges[c.edge];
    const Real nx = cosine * edge.normal.x - sine * edge.normal.y;
    const Real ny = sine * edge.normal.x + cosine * edge.normal.y;
    const Real ux = b.edges[vertex].vertex.x - q.x;
    const Real uy = b.edges[vertex].vertex.y - q.y;
    return {nx * ux + ny * uy - edge.offset, -nx, -ny, -ny * ux + nx * uy};
  }
};

// The sufficient condition itself: wherever an active function vanishes in the motion, it falls
// along the ray from the guard.
TEST(PlannerExtremal, ActiveFunctionsFallAlongRaysFromTheGuard) {
  int guards = 0;
  int zeros = 0;
  for (std::uint64_t seed = 0; seed < 72; ++seed) {
    SCOPED_TRACE(seed);
    Random random(900 + seed);
    worlds::Recipe recipe = worlds::recipes()[seed % worlds::recipes().size()];
    World world(worlds::random_scene(random, recipe));
    for (int i = 0; i < 20; ++i) {
      const Shape shape = random_shape(random, world);
      const double scale =
          largest_scale(world, shape, [](const Claims& c) { return c.guard.has_value(); });
      if (scale == 0.0) continue;
      const Claims claims = claims_of(world, shape, scale);
      if (!claims.guard) continue;
      ++guards;
      const pdg::Motion m = motion_of(world, shape, scale);
      const worlds::Box box = box_of(m, shape.theta);
      const worlds::Point guard{claims.guard->x, claims.guard->y, shape.theta};
      std::size_t at = 0;
      for (const planner::PairHeader& header : claims.list.pairs) {
        const pdg::ConvexPiece& a = world.labeller.robot().pieces[header.robot];
        const pdg::ConvexPiece& b = world.tree.piece(header.obstacle);
        for (std::size_t k = 0; k < header.count; ++k) {
          const pdg::Constraint& c = claims.list.constraints[at + k];
          const std::size_t ring =
              c.owner == EdgeOwner::kObstacle ? a.edges.size() : b.edges.size();
          for (int trial = 0; trial < 40; ++trial) {
            const Function s{
                a, b, c,
                (c.first + static_cast<std::size_t>(worlds::pick(random, 0, c.count - 1))) % ring};
            const auto place = worlds::random_place(random);
            worlds::Point q = box.at(place[0], place[1], place[2]);
            const Function::Value before = s.at(q);
            q.x -= before.s * before.dx;  // onto the contact surface: its normal has unit length
            q.y -= before.s * before.dy;
            if (q.x < box.low.x || q.x > box.low.x + box.size.x || q.y < box.low.y ||
                q.y > box.low.y + box.size.y)
              continue;
            ++zeros;
            const Function::Value v = s.at(q);
            const worlds::Point ray = q - guard;
            ASSERT_LT(ray.x * v.dx + ray.y * v.dy + ray.theta * v.dtheta, 1e-14L)
                << i << " scale " << scale;
          }
        }
        at += header.count;
      }
    }
  }
  EXPECT_GT(guards, 200);
  EXPECT_GT(zeros, 5000);
}

}  // namespace
