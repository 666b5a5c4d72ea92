// Pairs along straight motions, whose angle follows the translation; also at angles of 1e6 radians.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "generate.hpp"
#include "pdg/native/tolerances.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "posed.hpp"
#include "truth/exact.hpp"

namespace rounding {

namespace {

using planner::Configuration;
using planner::Interval;

// The part of the bound by which the exact least value of a range may be unknown.
constexpr double kSlack = 0x1p-10;

struct Way {
  Configuration from, to;  // user's units
  double at;               // where it comes near the target
};

// Through the case's target, or nearly.
Way way_of(Random& random, const PairCase& c, const bool adversarial) {
  const double unit = std::ldexp(1.0, -c.frame.exponent);
  const Vec2 t = planner::position_of(c.space, c.target[0], c.target[1]);
  const Vec2 user = c.frame.origin + unit * t;
  const double turns = adversarial && random.one_in(3) ? random.pick(-159000, 159000) : 0;
  const double theta = planner::radians_of_turns(c.target[2]) + 2.0 * std::numbers::pi * turns;
  const double length = unit * random.magnitude(adversarial ? 1e-12 : 1e-3, 0.5);
  const double angle = random.between(0.0, 6.3);
  const double turn = random.one_in(5) ? 0.0 : random.sign() * random.magnitude(1e-9, 3.0);
  const double at = random.one_in(2) ? 0.5 : random.unit();
  const Vec2 way = length * Vec2{std::cos(angle), std::sin(angle)};
  const Vec2 from = user - at * way;
  const Vec2 to = user + (1.0 - at) * way;
  return {{from.x, from.y, theta - at * turn}, {to.x, to.y, theta + (1.0 - at) * turn}, at};
}

}  // namespace

std::vector<Tally> segments(const Request& request) {
  Random random(request.seed);
  Tally tally{.family = "segment FREE"};
  std::vector<pdg::Constraint> active, remaining;
  while (tally.inputs < request.inputs) {
    const PairCase c = pair_case(random, request.adversarial);
    const Way way = way_of(random, c, request.adversarial);
    const pdg::ConvexPiece a = pdg::make_piece(c.a, exact::robot_frame(c.frame));
    const pdg::ConvexPiece b = pdg::make_piece(c.b, c.frame);
    planner::ScaledProblem problem;
    problem.frame = c.frame;
    problem.domain = c.space.domain;
    const planner::ScaledConfiguration from = planner::scaled(problem, way.from);
    const planner::ScaledConfiguration to = planner::scaled(problem, way.to);
    active.clear();
    pdg::all_constraints(a, b, active);
    Interval interval{0.0, 1.0};
    pdg::PairLabel label = pdg::PairLabel::kUndecided;
    const int steps = random.pick(0, request.adversarial ? 44 : 16);
    pdg::Motion m;
    for (int step = 0;; ++step) {
      const double middle = 0.5 * (interval.begin + interval.end);
      m = planner::motion_along(problem, from, to, interval);
      if (m.half_angle <= std::numbers::pi / 2) {
        const Posed posed(a, planner::rotation_at(planner::between(from, to, middle).theta));
        std::uint64_t evaluations = 0;
        remaining.clear();
        label = pdg::judge_pair(posed.view(), b, m, active, remaining, evaluations).label;
        if (step >= steps || label != pdg::PairLabel::kUndecided) break;
        active = remaining;
      } else if (step >= steps) {
        break;
      }
      (way.at < middle ? interval.end : interval.begin) = middle;
    }
    ++tally.inputs;
    if (m.half_angle > std::numbers::pi / 2) continue;
    const exact::Piece exact_a = exact::framed(exact::robot_frame(c.frame), c.a);
    const exact::Piece exact_b = exact::framed(c.frame, c.b);
    const exact::Way exact_way = exact::way_of(c.frame, way.from, way.to);
    const exact::Stretch stretch{interval.begin, interval.end};
    if (label == pdg::PairLabel::kApart)
      tally.claim(exact::apart(exact_a, exact_b, exact_way, stretch));
    const double middle = 0.5 * (interval.begin + interval.end);
    const Posed posed(a, planner::rotation_at(planner::between(from, to, middle).theta));
    const auto any = random.pick(0, static_cast<int>(active.size()) - 1);
    pdg::Constraint one = active[static_cast<std::size_t>(any)];
    const pdg::Range range =
        pdg::constraint_range(posed.view(), b, m, pdg::separation_error(a, b, m), one);
    const double largest_angle = std::max(std::abs(from.theta), std::abs(to.theta));
    const double bound = (kSeparationUnits + kAngleUnits * largest_angle) * pdg::kUnitRoundoff *
                         (a.reach + b.reach + m.reach);
    tally.not_above(range.lo,
                    exact::least_value(exact_a, exact_b, {one.owner, one.edge}, exact_way, stretch,
                                       range.lo, kSlack * bound),
                    bound);
  }
  return {tally};
}

}  // namespace rounding
