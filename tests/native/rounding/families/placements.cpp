// Single configurations, and the domain outside which nothing is free.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "claims.hpp"
#include "families.hpp"
#include "planar_planner/native/paths/placement.hpp"
#include "planar_planner/native/paths/state_check.hpp"

namespace rounding {

namespace {

using planner::Configuration;
using planner::Placement;
using planner::PlacementState;

Placement place(World& world, const Configuration& q) {
  return planner::place(world.problem, world.tree, world.labeller, q);
}

Configuration any_configuration(Random& random, const World& world, const double theta) {
  const planner::Rectangle& box = *world.problem.given.box;
  return {random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y), theta};
}

double any_angle(Random& random, const bool adversarial) {
  if (!adversarial) return random.between(-7.0, 7.0);
  const double turns = random.one_in(3) ? random.pick(-159000, 159000) : random.pick(-1, 1);
  const double part = random.one_in(2) ? random.pick(0, 7) / 8.0 : random.unit();
  return 2.0 * std::numbers::pi * (turns + part);
}

// Neighbouring doubles between a free configuration and one that is not, off by a few ulps.
Configuration in_contact(Random& random, World& world, const Stage& stage, const double theta) {
  Configuration q = any_configuration(random, world, theta);
  if (stage.critical && random.one_in(3)) {
    q = *stage.critical;
  } else {
    Configuration other = q;
    for (int i = 0; i < 10 && place(world, q).state != PlacementState::kFree; ++i)
      q = any_configuration(random, world, theta);
    for (int i = 0; i < 10 && place(world, other).state == PlacementState::kFree; ++i)
      other = any_configuration(random, world, theta);
    for (int i = 0; i < 60; ++i) {
      const Configuration middle{0.5 * q.x + 0.5 * other.x, 0.5 * q.y + 0.5 * other.y, theta};
      (place(world, middle).state == PlacementState::kFree ? q : other) = middle;
    }
  }
  const int most = random.one_in(2) ? 1 : 40;
  return {nudged(q.x, random.pick(-most, most)), nudged(q.y, random.pick(-most, most)),
          nudged(q.theta, random.pick(-1, 1))};
}

// Distance of the origin from a convex piece; not below it.
exact::Ball origin_distance(const exact::Piece& piece) {
  using exact::Ball;
  bool within = true;
  Ball nearest;
  for (std::size_t k = 0; k < piece.vertices.size(); ++k) {
    const exact::Vector& a = piece.vertices[k];
    const exact::Vector& along = piece.along[k];
    within = within && dot(piece.normals[k], a).certainly_not_negative();
    const Ball part = -dot(a, along);
    const Ball whole = dot(along, along);
    Ball here = absolute(dot(piece.normals[k], a));
    if (!part.certainly_positive())
      here = length(a);
    else if (!(whole - part).certainly_positive())
      here = length(a + along);
    nearest = k == 0 ? here : least(nearest, here);
  }
  return within ? Ball() : nearest;
}

// Radius of the largest disc about the origin in one piece.
exact::Ball inner_radius(const World& world) {
  exact::Ball most;
  for (std::size_t i = 0; i < world.body_pieces(); ++i) {
    const exact::Piece& piece = world.robot[i];
    exact::Ball here = dot(piece.normals[0], piece.vertices[0]);
    for (std::size_t k = 1; k < piece.vertices.size(); ++k)
      here = least(here, dot(piece.normals[k], piece.vertices[k]));
    most = greatest(most, here);
  }
  return most;
}

// docs/certificate.md, "Domain".
bool confirm_domain(const World& world) {
  using exact::Ball;
  const planner::Domain& d = world.problem.domain;
  const exact::Vector low = exact::framed(world.problem.frame, world.problem.given.box->low);
  const exact::Vector high = exact::framed(world.problem.frame, world.problem.given.box->high);
  const Ball distance = origin_distance(world.robot.back());
  const Ball inner = inner_radius(world);
  const Ball beyond[] = {low.x - Ball(d.low.x), low.y - Ball(d.low.y),
                         Ball(d.low.x) + Ball(d.size.x) - high.x,
                         Ball(d.low.y) + Ball(d.size.y) - high.y};
  for (const Ball& by : beyond)
    if (!(by - distance).certainly_not_negative() && !(by + inner).certainly_not_negative())
      return false;
  return true;
}

// A thin robot whose sharp end points at its origin, which lies just beyond it or within.
planner::Problem pointed(Random& random) {
  const double tip = random.sign() * random.magnitude(1e-6, 0.5);
  const double thin = random.magnitude(1e-16, 1e-9);
  pdg::Ring ring{{tip, 0.0}, {tip + 1.0, -thin * random.unit()}, {tip + 1.0, thin}};
  const double angle = random.one_in(2) ? 0.0 : random.between(0.0, 6.3);
  const pdg::Rotation turn{std::cos(angle), std::sin(angle)};
  for (Vec2& p : ring) p = pdg::rotate(turn, p);
  planner::Problem scene;
  scene.box = planner::Rectangle{{-1.0, -2.0}, {random.between(1.0, 3.0), 2.0}};
  if (strictly_convex(ring)) scene.robot.append({{ring}});
  return scene;
}

}  // namespace

std::vector<Tally> placements(const Request& request) {
  Random random(request.seed);
  Tally single{.family = "single configuration"};
  Tally check{.family = "state check"};
  Tally domain{.family = "domain"};
  while (single.inputs < request.inputs) {
    const Stage stage = any_stage(random, request.adversarial);
    World world(stage.scene);
    planner::StateCheck states(world.problem);
    for (int i = 0; i < 4; ++i) {
      const double theta = any_angle(random, request.adversarial);
      const Configuration q = request.adversarial ? in_contact(random, world, stage, theta)
                                                  : any_configuration(random, world, theta);
      const Placement p = place(world, q);
      const exact::Box here = exact::point_of(world.problem.frame, {q.x, q.y}, q.theta);
      ++single.inputs;
      ++check.inputs;
      if (states.is_free(q)) check.claim(confirm_free(world, here));
      if (p.state == PlacementState::kFree) single.claim(confirm_free(world, here));
      if (p.state == PlacementState::kColliding) single.claim(confirm_pair(world, p.witness, here));
    }
  }
  while (domain.inputs < request.inputs) {
    planner::Problem scene = request.adversarial && random.one_in(2)
                                 ? pointed(random)
                                 : any_stage(random, request.adversarial).scene;
    if (scene.robot.size() == 0) continue;
    const World world(std::move(scene));
    ++domain.inputs;
    domain.claim(confirm_domain(world));
  }
  return {single, check, domain};
}

}  // namespace rounding
