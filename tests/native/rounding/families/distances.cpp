// Bounds of D_g between two configurations, which hold as they are, against the formulas they come
// from; and the displacement that other families need.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "pdg/native/depth/displacement.hpp"
#include "pdg/native/geometry/enclosing_circle.hpp"
#include "pdg/native/tolerances.hpp"
#include "piece_sets.hpp"

namespace rounding {

namespace {

using exact::Ball;

exact::Vector vector_of(const Vec2 v) {
  return {Ball(v.x), Ball(v.y)};
}

// |theta1 - theta0| modulo full turns, at most pi.
Ball turn_of(const Move& move) {
  const Ball difference = Ball(move.to.theta) - Ball(move.from.theta);
  const Ball whole = exact::scaled(exact::pi(), 1);
  const double turns = std::nearbyint(static_cast<double>(difference.middle / whole.middle));
  return absolute(difference - Ball(turns) * whole);
}

// A lower bound of the radius of the smallest enclosing circle, exact for the right shares; any
// will do, so the core may propose them.
Ball radius_of(const std::vector<Vec2>& points) {
  std::vector<pdg::WeightedPoint> weighted;
  weighted.reserve(points.size());
  for (const Vec2 p : points) weighted.push_back({p, 0.0});
  const pdg::WeightedCentre centre = pdg::weighted_centre(weighted);
  Ball sum;
  Ball square;
  for (int i = 0; i < centre.support_size; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const Ball share(std::max(centre.shares[a], 0.0));
    sum = sum + share;
    for (std::size_t b = 0; b < a; ++b) {
      const exact::Vector d = vector_of(centre.support[a].p) - vector_of(centre.support[b].p);
      square = square + share * Ball(std::max(centre.shares[b], 0.0)) * dot(d, d);
    }
  }
  return square_root(square) / sum;
}

void bounds_of_motion(Random& random, const bool adversarial, Tally& tally) {
  const SetCase c = set_case(random, adversarial);
  const Move move = move_of(random, c, adversarial);
  if (move.from.t == move.to.t && move.from.theta == move.to.theta) return;
  ++tally.inputs;
  std::vector<Vec2> vertices;
  for (const ConvexPolygon& polygon : c.a.polygons)
    vertices.insert(vertices.end(), polygon.begin(), polygon.end());
  const pdg::DistanceBounds found = pdg::generalized_distance_bounds(c.a, move.from, move.to);
  const Ball turn = turn_of(move);
  const Ball low = greatest(displacement_of(c.a, move), turn * radius_of(vertices));
  // The motion about the centre that was found.
  const Ball chord = Ball(2.0) * exact::sine_cosine(exact::scaled(turn, -1)).sine;
  const Ball excess = turn * turn - chord * chord;
  const exact::SineCosine r0 = exact::sine_cosine(Ball(move.from.theta));
  const exact::SineCosine r1 = exact::sine_cosine(Ball(move.to.theta));
  const exact::Vector shift = vector_of(move.to.t) - vector_of(move.from.t);
  Ball high;
  for (const Vec2 v : vertices) {
    const exact::Vector p = vector_of(v);
    const exact::Vector way = rotated(r1, p) - rotated(r0, p) + shift;
    const exact::Vector arm = p - vector_of(found.centre);
    high = greatest(high, dot(way, way) + excess * dot(arm, arm));
  }
  high = square_root(high);
  tally.claim((low - Ball(found.lower)).certainly_not_negative());
  tally.claim((Ball(found.upper) - high).certainly_not_negative());
  // Not needlessly wide either: by twice the errors that they are moved outward by.
  const double angle_error = pdg::kTurnErrorUnits * pdg::kUnitRoundoff *
                             (1.0 + std::abs(move.from.theta) + std::abs(move.to.theta));
  const double arm = c.a.radius + pdg::norm(found.centre);
  const double room = 2.0 * (displacement_error(c.a, move) + angle_error * arm) +
                      64.0 * pdg::kUnitRoundoff * high.value();
  tally.not_below(found.lower, low, room);
  tally.not_above(found.upper, high, room);
}

}  // namespace

Move move_of(Random& random, const SetCase& c, const bool adversarial) {
  for (;;) {
    const double turns = adversarial && random.one_in(3) ? random.between(-1e6, 1e6) : 0.0;
    const double by = random.one_in(2) ? random.magnitude(1e-12, 1.0) : 1.0;
    const pdg::Pose from{c.cell.centre.t, c.cell.centre.theta + turns};
    const pdg::Pose to{
        from.t + by * Vec2{random.between(-1.0, 1.0) * c.a.radius, c.a.radius},
        from.theta + by * random.between(-3.0, 3.0) + (random.one_in(3) ? turns : 0.0)};
    if (std::max(std::abs(from.theta), std::abs(to.theta)) <= 2e6) return {from, to};
  }
}

Ball displacement_of(const pdg::PieceSet& body, const Move& move) {
  const exact::SineCosine r0 = exact::sine_cosine(Ball(move.from.theta));
  const exact::SineCosine r1 = exact::sine_cosine(Ball(move.to.theta));
  const exact::Vector shift = vector_of(move.to.t) - vector_of(move.from.t);
  Ball most;
  for (const ConvexPolygon& polygon : body.polygons)
    for (const Vec2 v : polygon) {
      const exact::Vector p = vector_of(v);
      most = greatest(most, length(rotated(r1, p) - rotated(r0, p) + shift));
    }
  return most;
}

double displacement_error(const pdg::PieceSet& body, const Move& move) {
  return pdg::kDisplacementErrorUnits * pdg::kUnitRoundoff *
         (pdg::norm(move.from.t) + pdg::norm(move.to.t) +
          body.radius * (1.0 + std::abs(move.from.theta) + std::abs(move.to.theta)));
}

std::vector<Tally> distances(const Request& request) {
  Random random(request.seed);
  std::vector<Tally> out{{.family = "D_g bounds", .leans_on_margin = false}};
  while (out[0].inputs < request.inputs) bounds_of_motion(random, request.adversarial, out[0]);
  return out;
}

}  // namespace rounding
