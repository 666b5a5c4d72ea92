// The bracket of PD^g: its lower end against exactly free configurations near its optimum, its
// upper ends against the exact distances of the configurations that attain them.
#include <cmath>
#include <optional>
#include <stdexcept>

#include "families.hpp"
#include "pdg/native/bounds/bracket.hpp"
#include "pdg/native/tolerances.hpp"
#include "piece_sets.hpp"

namespace rounding {

namespace {

using exact::Ball;

constexpr std::uint64_t kInputsPerBracket = 100;
constexpr std::uint64_t kNodes = 200;
constexpr int kTries = 24;  // of configurations round the one found

// No interiors of pieces meet, beyond doubt.
bool free_at(const SetCase& c, const pdg::Pose& pose) {
  const exact::Box here = box_of(pose, {});
  for (const ConvexPolygon& a : c.a.polygons)
    for (const ConvexPolygon& b : c.b.polygons)
      if (!apart(exact::framed(pdg::Frame{}, a), exact::framed(pdg::Frame{}, b), here))
        return false;
  return true;
}

// The least displacement of exactly free configurations about `pose`, from it by few roundings on.
std::optional<Ball> least_nearby(Random& random, const SetCase& c, const pdg::Pose& from,
                                 const pdg::Pose& pose) {
  std::optional<Ball> best;
  const double size = c.a.radius + pdg::norm(pose.t);
  for (int k = 0; k < kTries; ++k) {
    const double step = k == 0 ? 0.0 : size * random.magnitude(1e-17, 1e-13);
    const double way = random.between(-4.0, 4.0);
    const pdg::Pose near{pose.t + step * Vec2{std::cos(way), std::sin(way)},
                         random.one_in(2) ? pose.theta : nudged(pose.theta, random.pick(-2, 2))};
    if (!free_at(c, near)) continue;
    const Ball here = displacement_of(c.a, {from, near});
    best = best ? least(*best, here) : here;
  }
  return best;
}

void bracketed(Random& random, const bool adversarial, Tally& lower, Tally& upper) {
  const SetCase c = set_case(random, adversarial);
  const pdg::Pose from = c.cell.centre;
  const double rel_tol = random.one_in(4) ? 0.0 : random.magnitude(1e-12, 1e-2);
  pdg::Bracket found;
  try {
    found = pdg::bracket_depth(c.a, c.b, from, {rel_tol, kNodes, [] { return false; }});
  } catch (const std::invalid_argument&) {
    return;  // placed outside the range of exact arithmetic
  }
  ++lower.inputs;
  ++upper.inputs;
  lower.claim(found.lower <= found.displaced.displacement);
  if (found.displaced.displacement == 0.0) return;  // free where it is
  upper.claim(
      (Ball(found.displaced.displacement) - displacement_of(c.a, {from, found.displaced.pose}))
          .certainly_not_negative());
  upper.claim((Ball(found.distanced.distance) - displacement_of(c.a, {from, found.distanced.pose}))
                  .certainly_not_negative());
  const std::optional<Ball> truth = least_nearby(random, c, from, found.displaced.pose);
  if (!truth) return;
  lower.claim((*truth - Ball(found.lower)).certainly_not_negative());
  const double unit = pdg::kSliceErrorUnits * pdg::kUnitRoundoff *
                      (c.a.radius * (2.0 + std::abs(from.theta)) + c.b.radius +
                       2.0 * pdg::norm(from.t) + found.displaced.displacement);
  lower.not_above(found.lower, *truth, unit);
}

}  // namespace

std::vector<Tally> brackets(const Request& request) {
  Random random(request.seed);
  std::vector<Tally> out{{.family = "bracket, lower end", .leans_on_margin = false},
                         {.family = "bracket, upper ends", .leans_on_margin = false}};
  while (out[0].inputs * kInputsPerBracket < request.inputs)
    bracketed(random, request.adversarial, out[0], out[1]);
  return out;
}

}  // namespace rounding
