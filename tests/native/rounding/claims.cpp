#include "claims.hpp"

#include <algorithm>

namespace rounding {

using exact::Axis;
using exact::Ball;
using exact::Box;
using exact::Piece;
using exact::Sinusoid;
using exact::Vector;
using pdg::EdgeOwner;

namespace {

bool inside(const World& world, const Box& box) {
  for (const exact::Wall& wall : world.walls)
    if (!wall_least(world.robot.back(), wall, box).certainly_not_negative()) return false;
  return true;
}

bool pair_apart(const World& world, const std::size_t robot, const Piece& b, const Box& box) {
  const Piece& a = world.robot[robot];
  return circle_distance(a, b, box).certainly_not_negative() ||
         box_distance(world.reach, low_corner(b), high_corner(b), box).certainly_not_negative() ||
         apart(a, b, box);
}

// f(q) = M(delta) . stuff, written as v cos + w sin about the box's centre.
Sinusoid turning(const Vector& normal, const Vector& p) {
  return {dot(normal, p), dot(perpendicular(normal), p)};
}

// Everything of the sum that a joint proof is made of.
struct Sum {
  Ball value;         // what does not turn
  Sinusoid sinusoid;  // what turns
  Vector fixed, own;  // normals of obstacles; of the robot, turned to the centre
};

void add_obstacle_term(Sum& sum, const Ball& weight, const Vector& n, const Ball& offset,
                       const Vector& vertex, const Box& box) {
  const Vector p = rotated(box.rotation, vertex);
  sum.value = sum.value + weight * (dot(n, box.t) - offset);
  sum.sinusoid.v = sum.sinusoid.v + weight * dot(n, p);
  sum.sinusoid.w = sum.sinusoid.w + weight * dot(n, perpendicular(p));
  sum.fixed = sum.fixed + weight * n;
}

void add_robot_term(Sum& sum, const Ball& weight, const Piece& a, const std::size_t edge,
                    const Vector& vertex, const Box& box) {
  const Vector n = rotated(box.rotation, a.normals[edge]);
  const Sinusoid f = turning(n, vertex - box.t);
  sum.value = sum.value - weight * dot(a.normals[edge], a.vertices[edge]);
  sum.sinusoid.v = sum.sinusoid.v + weight * f.v;
  sum.sinusoid.w = sum.sinusoid.w + weight * f.w;
  sum.own = sum.own + weight * n;
}

// docs/certificate.md, "FULL jointly".
bool negative(const Sum& sum, const Box& box) {
  const Ball turn = Ball(1.0) - box.half.cosine;
  const Vector d = sum.fixed - sum.own;
  const Ball& s = box.half.sine;
  const Ball x = absolute(d.x) + turn * absolute(sum.own.x) + s * absolute(sum.own.y);
  const Ball y = absolute(d.y) + turn * absolute(sum.own.y) + s * absolute(sum.own.x);
  const Ball extent = absolute(box.g1.x) * x + absolute(box.g2.y) * y;
  return (sinusoid_largest(sum.sinusoid, box) + sum.value + extent).certainly_negative();
}

// Every function of the pair but those listed is negative all over the box.
bool others_negative(const World& world, const planner::PairAxes& pair, const Box& box) {
  if (pair.obstacle < world.tree.wall_count()) return true;  // a wall has one
  const Piece& a = world.robot[pair.robot];
  const Piece& b = world.obstacle(pair.obstacle);
  for (const Axis& axis : axes_of(a, b)) {
    const bool listed =
        std::any_of(pair.axes.begin(), pair.axes.end(), [&](const planner::PairAxes::Axis& other) {
          return other.owner == axis.owner && other.edge == axis.edge;
        });
    if (!listed && !largest_value(a, b, axis, box).certainly_negative()) return false;
  }
  return true;
}

bool sum_negative(const World& world, const planner::JointSum& terms, const Box& box) {
  Sum sum;
  for (const planner::JointTerm& term : terms) {
    if (!(term.weight >= 0.0)) return false;
    const Ball weight(term.weight);
    const Piece& a = world.robot[term.robot];
    if (term.obstacle < world.tree.wall_count()) {
      const exact::Wall& wall = world.walls[term.obstacle];
      add_obstacle_term(sum, weight, wall.normal, wall.offset, a.vertices[term.vertex], box);
      continue;
    }
    const Piece& b = world.obstacle(term.obstacle);
    const Vector& n = b.normals[term.owner == EdgeOwner::kObstacle ? term.edge : 0];
    if (term.owner == EdgeOwner::kObstacle)
      add_obstacle_term(sum, weight, n, dot(n, b.vertices[term.edge]), a.vertices[term.vertex],
                        box);
    else
      add_robot_term(sum, weight, a, term.edge, b.vertices[term.vertex], box);
  }
  return negative(sum, box);
}

// Are all terms of chosen edges? `choice` numbers the choices as digits do.
bool fits(const planner::JointProof& proof, const planner::JointSum& terms, std::size_t choice) {
  std::vector<const planner::PairAxes::Axis*> chosen;
  for (const planner::PairAxes& pair : proof.pairs) {
    chosen.push_back(&pair.axes[choice % pair.axes.size()]);
    choice /= pair.axes.size();
  }
  return std::all_of(terms.begin(), terms.end(), [&](const planner::JointTerm& term) {
    for (std::size_t i = 0; i < proof.pairs.size(); ++i)
      if (proof.pairs[i].obstacle == term.obstacle && proof.pairs[i].robot == term.robot)
        return chosen[i]->owner == term.owner && chosen[i]->edge == term.edge;
    return false;
  });
}

bool confirm_joint(const World& world, const planner::JointProof& proof, const Box& box) {
  std::size_t choices = 1;
  for (const planner::PairAxes& pair : proof.pairs) {
    if (pair.axes.empty() || !others_negative(world, pair, box)) return false;
    choices *= pair.axes.size();
  }
  for (const planner::JointSum& terms : proof.sums)
    if (!sum_negative(world, terms, box)) return false;
  for (std::size_t choice = 0; choice < choices; ++choice)
    if (std::none_of(proof.sums.begin(), proof.sums.end(),
                     [&](const planner::JointSum& terms) { return fits(proof, terms, choice); }))
      return false;
  return true;
}

class StarCheck {
 public:
  StarCheck(const Box& box, const Vec2 guard)
      : box_(box),
        guard_{Ball(guard.x), Ball(guard.y)},
        k_(box.half.cosine + box.h * box.half.sine),
        s_(box.half.sine - box.h * box.half.cosine) {}

  // For one obstacle edge or wall, outward normal n.
  [[nodiscard]] bool towards(const Piece& a, const Vector& n, const Ball& offset) const {
    for (std::size_t k = 0; k < a.vertices.size(); ++k) {
      const Vector p = rotated(box_.rotation, a.vertices[k]);
      const Vector after = rotated(box_.rotation, a.along[k]);
      const Vector before = rotated(box_.rotation, a.along[k == 0 ? a.along.size() - 1 : k - 1]);
      const Sinusoid f = {dot(n, p), dot(n, perpendicular(p))};
      if (!possible_minimiser({dot(n, after), dot(n, perpendicular(after))},
                              {dot(n, before), dot(n, perpendicular(before))}))
        continue;
      const Ball shift = dot(n, box_.t) - offset;
      const Ball extent = absolute(dot(n, box_.g1)) + absolute(dot(n, box_.g2));
      if ((sinusoid_least(f, box_) + shift - extent).certainly_not_negative()) continue;
      if ((sinusoid_largest(f, box_) + shift + extent).certainly_negative()) continue;
      const Ball slack = dot(n, guard_) - offset + least(f.v, f.v * k_) - absolute(f.w) * s_;
      if (!slack.certainly_positive()) return false;
    }
    return true;
  }

  [[nodiscard]] bool turning_edge(const Piece& a, const std::size_t edge, const Piece& b) const {
    const Vector n = rotated(box_.rotation, a.normals[edge]);
    const Ball offset = dot(a.normals[edge], a.vertices[edge]);
    for (std::size_t k = 0; k < b.vertices.size(); ++k) {
      const Vector& before = b.along[k == 0 ? b.along.size() - 1 : k - 1];
      if (!possible_minimiser(turning(n, b.along[k]), turning(n, before))) continue;
      Ball lowest, highest, drift;
      for (int corner = 0; corner < 4; ++corner) {
        const Vector t = box_.t + Ball(corner % 2 == 0 ? -1.0 : 1.0) * box_.g1 +
                         Ball(corner / 2 == 0 ? -1.0 : 1.0) * box_.g2;
        const Sinusoid f = turning(n, b.vertices[k] - t);
        const Ball lo = sinusoid_least(f, box_);
        const Ball hi = sinusoid_largest(f, box_);
        const Sinusoid across = turning(perpendicular(n), t - guard_);
        const Ball far = greatest(sinusoid_largest(across, box_), -sinusoid_least(across, box_));
        lowest = corner == 0 ? lo : least(lowest, lo);
        highest = corner == 0 ? hi : greatest(highest, hi);
        drift = corner == 0 ? far : greatest(drift, far);
      }
      if ((lowest - offset).certainly_not_negative()) continue;
      if ((highest - offset).certainly_negative()) continue;
      const Sinusoid own = turning(n, b.vertices[k] - guard_);
      const Ball slack = least(own.v, own.v * k_) - offset - box_.h * drift - absolute(own.w) * s_;
      if (!slack.certainly_positive()) return false;
    }
    return true;
  }

 private:
  // Vertex k of a convex ring is the least somewhere in the box iff somewhere the step to the next
  // is not down and the step from the one before is not up. On so short an interval each of the two
  // sets is an interval: they meet at an end, or where a step is level.
  [[nodiscard]] bool possible_minimiser(const Sinusoid& after, const Sinusoid& before) const {
    const auto both = [&](const Ball& c, const Ball& s) {
      return (after.v * c + after.w * s).possibly_not_negative() &&
             (-(before.v * c + before.w * s)).possibly_not_negative();
    };
    if (both(box_.half.cosine, box_.half.sine) || both(box_.half.cosine, -box_.half.sine))
      return true;
    for (const Sinusoid& step : {after, before}) {
      for (const double sign : {-1.0, 1.0}) {
        const Ball c = Ball(sign) * step.w;
        const Ball s = Ball(-sign) * step.v;
        const Ball size = square_root(c * c + s * s);
        if ((c - size * box_.half.cosine).possibly_not_negative() && both(c, s)) return true;
      }
    }
    return false;
  }

  const Box& box_;
  Vector guard_;
  Ball k_, s_;
};

}  // namespace

bool confirm_free(const World& world, const Box& box) {
  if (!inside(world, box)) return false;
  for (std::size_t i = 0; i < world.body_pieces(); ++i)
    for (const std::vector<Piece>& polygon : world.obstacles)
      for (const Piece& b : polygon)
        if (!pair_apart(world, i, b, box)) return false;
  return true;
}

bool confirm_pair(const World& world, const planner::Witness& witness, const Box& box) {
  const Piece& a = world.robot[witness.robot];
  if (witness.obstacle < world.tree.wall_count())
    return wall_largest(a, world.walls[witness.obstacle], box).certainly_negative();
  return overlap(a, world.obstacle(witness.obstacle), box);
}

bool confirm_full(const World& world, const planner::FullClaim& claim, const Box& box) {
  return claim.joint ? confirm_joint(world, claim.proof, box)
                     : confirm_pair(world, claim.witness, box);
}

bool confirm_star(const World& world, const Vec2 guard, const Box& box) {
  Box here = box;
  here.t = {Ball(guard.x), Ball(guard.y)};
  here.g1 = here.g2 = {};
  here.h = Ball();
  here.half = {Ball(), Ball(1.0)};
  if (!confirm_free(world, here)) return false;
  const StarCheck check(box, guard);
  for (const exact::Wall& wall : world.walls)
    if (wall_largest(world.robot.back(), wall, box).possibly_not_negative() &&
        !check.towards(world.robot.back(), wall.normal, wall.offset))
      return false;
  for (std::size_t i = 0; i < world.body_pieces(); ++i) {
    const Piece& a = world.robot[i];
    for (const std::vector<Piece>& polygon : world.obstacles)
      for (const Piece& b : polygon) {
        if (pair_apart(world, i, b, box)) continue;
        for (const Axis& axis : axes_of(a, b)) {
          if (largest_value(a, b, axis, box).certainly_negative()) continue;
          const bool seen = axis.owner == EdgeOwner::kObstacle
                                ? check.towards(a, b.normals[axis.edge],
                                                dot(b.normals[axis.edge], b.vertices[axis.edge]))
                                : check.turning_edge(a, axis.edge, b);
          if (!seen) return false;
        }
      }
  }
  return true;
}

}  // namespace rounding
