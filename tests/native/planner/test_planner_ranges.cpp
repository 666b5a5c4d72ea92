// Ranges of the separating-axis functions over whole motions, against every function sampled in
// long double.
#include <gtest/gtest.h>

#include "pdg/native/separation/separation.hpp"
#include "pdg/native/tolerances.hpp"
#include "planner_worlds.hpp"

namespace {

using pdg::Constraint;
using pdg::ConvexPiece;
using pdg::EdgeOwner;
using pdg::Motion;
using pdg::Range;
using pdg::Rotation;
using pdg::Vec2;
using worlds::Random;
using worlds::Real;

struct Pair {
  ConvexPiece a, b;
  worlds::RealRing ring_a, ring_b;
};

pdg::ConvexPolygon random_ring(Random& random, const double size, const double sliver,
                               const double off) {
  worlds::Recipe recipe;
  recipe.sliver = sliver;
  const pdg::Vec2 centre{worlds::uniform(random, -off, off), worlds::uniform(random, -off, off)};
  return worlds::random_shape(random, recipe, size, centre).rings[0];
}

Pair random_pair(Random& random, const int kind) {
  const double sliver = kind == 1 ? 1e-4 : kind == 2 ? 1e-15 : 0.2;
  const double size = kind == 2 ? 0.02 : 0.5;
  const double off = kind == 3 ? 3.0 : kind == 4 ? 0.05 : 0.5;
  const pdg::ConvexPolygon a = random_ring(random, size, sliver, off);
  const pdg::ConvexPolygon b = random_ring(random, kind == 4 ? 2.0 : 0.5, sliver, off);
  Pair pair{pdg::make_piece(a, {}), pdg::make_piece(b, {}), {}, {}};
  for (const pdg::Vec2 p : a) pair.ring_a.push_back({p.x, p.y});
  for (const pdg::Vec2 p : b) pair.ring_b.push_back({p.x, p.y});
  return pair;
}

struct Posed {
  Posed(const ConvexPiece& a, const double angle) : piece(a) {
    rotation = {std::cos(angle), std::sin(angle)};
    for (const pdg::Edge& edge : a.edges) {
      vertices.push_back(pdg::rotate(rotation, edge.vertex));
      normals.push_back(pdg::rotate(rotation, edge.normal));
    }
  }
  [[nodiscard]] pdg::PosedPiece view() const {
    return {&piece, vertices, normals, pdg::rotate(rotation, piece.inner_centre)};
  }
  const ConvexPiece& piece;
  Rotation rotation;
  std::vector<pdg::Vec2> vertices, normals;
};

Motion random_motion(Random& random, const bool segment) {
  constexpr double kReach = 4.0;
  const double size = std::exp(worlds::uniform(random, std::log(1e-4), std::log(0.7)));
  const Vec2 t{worlds::uniform(random, -1.0, 1.0), worlds::uniform(random, -1.0, 1.0)};
  Vec2 g1;
  Vec2 g2;
  if (segment) {
    g1 = {worlds::uniform(random, -size, size), worlds::uniform(random, -size, size)};
  } else {
    g1 = {worlds::pick(random, 0, 4) == 0 ? 0.0 : worlds::uniform(random, 0.0, size), 0.0};
    g2 = {0.0, worlds::pick(random, 0, 4) == 0 ? 0.0 : worlds::uniform(random, 0.0, size)};
  }
  const double widest = segment ? std::numbers::pi / 2 : std::numbers::pi / 4;
  double half = std::min(widest, std::exp(worlds::uniform(random, std::log(1e-4), 1.0)));
  if (worlds::pick(random, 0, 5) == 0) half = 0.0;
  if (!segment) return pdg::make_motion(t, g1, g2, pdg::half_angle_of(half), kReach);
  const double turn = worlds::pick(random, 0, 1) == 0 ? half : -half;
  return pdg::make_segment_motion(t, g1, turn, kReach);
}

// One separating-axis function at a configuration, over a cyclic range of vertices.
Real function_at(const Pair& pair, const Constraint& c, const worlds::Point& q) {
  const bool obstacle = c.owner == EdgeOwner::kObstacle;
  const Real cosine = std::cos(q.theta);
  const Real sine = std::sin(q.theta);
  worlds::RealRing placed;
  for (const worlds::RealVec a : pair.ring_a)
    placed.push_back({cosine * a.x - sine * a.y + q.x, sine * a.x + cosine * a.y + q.y});
  const worlds::RealRing& edges = obstacle ? pair.ring_b : placed;
  const worlds::RealRing& others = obstacle ? placed : pair.ring_b;
  const worlds::RealVec p = edges[c.edge];
  const worlds::RealVec r = edges[(c.edge + 1U) % edges.size()];
  const Real length = std::hypot(r.x - p.x, r.y - p.y);
  Real least = INFINITY;
  for (std::size_t i = 0; i < c.count; ++i) {
    const worlds::RealVec o = others[(c.first + i) % others.size()];
    least = std::min(least, ((r.y - p.y) * (o.x - p.x) - (r.x - p.x) * (o.y - p.y)) / length);
  }
  return least;
}

worlds::Point sample(Random& random, const Motion& m, const double angle) {
  const auto place = worlds::random_place(random);
  const Real s = 2 * place[0] - 1;
  const Real r = 2 * place[1] - 1;
  const Real delta = m.turn != 0.0 ? s * m.turn : (2 * place[2] - 1) * Real{m.half_angle};
  return {m.t.x + s * m.g1.x + r * m.g2.x, m.t.y + s * m.g1.y + r * m.g2.y, angle + delta};
}

// The part of the motion about one of its configurations.
Motion part(Random& random, const Motion& m, double& angle) {
  const double scale = worlds::uniform(random, 0.1, 0.6);
  const double s = worlds::uniform(random, scale - 1.0, 1.0 - scale);
  const double r = worlds::uniform(random, scale - 1.0, 1.0 - scale);
  const double d = m.turn != 0.0 ? s : worlds::uniform(random, scale - 1.0, 1.0 - scale);
  const Vec2 t = m.t + s * m.g1 + r * m.g2;
  angle += d * (m.turn != 0.0 ? m.turn : m.half_angle);
  if (m.turn != 0.0) return pdg::make_segment_motion(t, scale * m.g1, scale * m.turn, m.reach);
  return pdg::make_motion(t, scale * m.g1, scale * m.g2, pdg::half_angle_of(scale * m.half_angle),
                          m.reach);
}

Constraint whole(const Pair& pair, const EdgeOwner owner, const std::size_t edge) {
  const auto count = (owner == EdgeOwner::kObstacle ? pair.ring_a : pair.ring_b).size();
  return {static_cast<std::uint16_t>(edge), 0, static_cast<std::uint16_t>(count), owner, 0};
}

TEST(PlannerRanges, HoldEverySampleAndKeepEveryMinimiser) {
  Random random(11);
  int narrowed = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const Pair pair = random_pair(random, trial % 5);
    const bool segment = trial % 3 == 0;
    const Motion m = random_motion(random, segment);
    const double angle = worlds::uniform(random, -3.0, 3.0);
    const Posed posed(pair.a, angle);
    const double error = pdg::separation_error(pair.a, pair.b, m);
    for (const EdgeOwner owner : {EdgeOwner::kObstacle, EdgeOwner::kRobot}) {
      const std::size_t edges =
          owner == EdgeOwner::kObstacle ? pair.ring_b.size() : pair.ring_a.size();
      for (std::size_t k = 0; k < edges; ++k) {
        const Constraint all = whole(pair, owner, k);
        Constraint kept = all;
        const Range range = pdg::constraint_range(posed.view(), pair.b, m, error, kept);
        narrowed += kept.count < all.count;
        ASSERT_GE(kept.count, 1);
        for (int i = 0; i < 12; ++i) {
          const worlds::Point q = sample(random, m, angle);
          const Real s = function_at(pair, all, q);
          ASSERT_GE(s, range.lo - error) << trial;
          ASSERT_LE(s, range.hi + error) << trial;
          ASSERT_NEAR(static_cast<double>(function_at(pair, kept, q)), static_cast<double>(s),
                      error);
        }
        // The narrowed constraint serves a part of the motion as well as the whole one does.
        double angle_of_part = angle;
        const Motion inner = part(random, m, angle_of_part);
        const Posed posed_part(pair.a, angle_of_part);
        Constraint again = kept;
        const Range within = pdg::constraint_range(posed_part.view(), pair.b, inner, error, again);
        for (int i = 0; i < 6; ++i) {
          const Real s = function_at(pair, all, sample(random, inner, angle_of_part));
          ASSERT_GE(s, within.lo - error) << trial;
          ASSERT_LE(s, within.hi + error) << trial;
        }
      }
    }
  }
  EXPECT_GT(narrowed, 1000);
}

// With one generator only, or turning only, the bounds are attained: nothing is given away.
TEST(PlannerRanges, AreTightWhereTheyAreExact) {
  Random random(12);
  for (int trial = 0; trial < 150; ++trial) {
    const Pair pair = random_pair(random, trial % 5);
    const Motion any = random_motion(random, false);
    const Motion m = flattened(flattened(any, pdg::MotionPart::kG1), pdg::MotionPart::kG2);
    const double angle = worlds::uniform(random, -3.0, 3.0);
    const Posed posed(pair.a, angle);
    const double error = pdg::separation_error(pair.a, pair.b, m);
    for (const EdgeOwner owner : {EdgeOwner::kObstacle, EdgeOwner::kRobot}) {
      const std::size_t edges =
          owner == EdgeOwner::kObstacle ? pair.ring_b.size() : pair.ring_a.size();
      for (std::size_t k = 0; k < edges; ++k) {
        Constraint c = whole(pair, owner, k);
        const Range range = pdg::constraint_range(posed.view(), pair.b, m, error, c);
        Real low = INFINITY;
        Real high = -INFINITY;
        constexpr int kSteps = 200;
        for (int i = 0; i <= kSteps; ++i) {
          const Real delta = m.half_angle * (2.0L * i / kSteps - 1);
          const Real s = function_at(pair, whole(pair, owner, k), {m.t.x, m.t.y, angle + delta});
          low = std::min(low, s);
          high = std::max(high, s);
        }
        const double slack = 2.0 * m.half_angle / kSteps * 8.0 + error;  // slope at most 8
        ASSERT_NEAR(static_cast<double>(low), range.lo, slack) << trial;
        ASSERT_NEAR(static_cast<double>(high), range.hi, slack) << trial;
      }
    }
  }
}

// hi is no looser than the least over the vertices of their own maxima.
TEST(PlannerRanges, UpperBoundBeatsTheBestVertex) {
  Random random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const Pair pair = random_pair(random, trial % 5);
    const Motion m = random_motion(random, trial % 3 == 0);
    const double angle = worlds::uniform(random, -3.0, 3.0);
    const Posed posed(pair.a, angle);
    const double error = pdg::separation_error(pair.a, pair.b, m);
    for (const EdgeOwner owner : {EdgeOwner::kObstacle, EdgeOwner::kRobot}) {
      Constraint c = whole(pair, owner, 0);
      const Range range = pdg::constraint_range(posed.view(), pair.b, m, error, c);
      for (std::uint16_t k = 0; k < whole(pair, owner, 0).count; ++k) {
        Constraint single = whole(pair, owner, 0);
        single.first = k;
        single.count = 1;
        const Range alone = pdg::constraint_range(posed.view(), pair.b, m, error, single);
        ASSERT_LE(range.hi, alone.hi + error) << trial;
        ASSERT_LE(range.lo, alone.lo + error) << trial;
      }
    }
  }
}

}  // namespace
