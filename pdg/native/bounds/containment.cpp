#include "containment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "pdg/native/tolerances.hpp"
#include "tuning.hpp"

namespace pdg {
namespace {

using Interval = ContainmentScratch::Interval;

// The stretch of side j's line that the sides before it leave, within `reach` of the origin.
struct Stretch {
  Line line;
  double low = 0.0;
  double high = 0.0;
};

std::optional<Stretch> stretch_on(const std::span<const HalfPlane> sides, const std::size_t j,
                                  const double reach) {
  const HalfPlane& own = sides[j];
  if (std::abs(own.offset) > reach) return std::nullopt;
  Stretch stretch{{own.offset * own.normal, perp(own.normal)}, -reach, reach};
  for (const HalfPlane& side : sides.first(j)) {
    const double slope = dot(side.normal, stretch.line.along);
    const double room = side.offset - dot(side.normal, stretch.line.foot);
    if (slope > 0.0) {
      stretch.high = std::min(stretch.high, room / slope);
    } else if (slope < 0.0) {
      stretch.low = std::max(stretch.low, room / slope);
    } else if (room < 0.0) {
      return std::nullopt;
    }
  }
  if (stretch.low > stretch.high) return std::nullopt;
  return stretch;
}

// max over spokes u of normal . R u.
double support(const std::vector<Vec2>& spokes, const Vec2 normal_in_body) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec2 u : spokes) most = std::max(most, dot(normal_in_body, u));
  return most;
}

// A lower bound of the support over all turns within an angle h <= pi/2, of cosine c and sine s: a
// spoke's part v cos(d) + w sin(d), v >= 0, is least at an end, v c - |w| s. The spokes go round
// the circle's centre, so one has v >= 0.
double lowest_support(const std::vector<Vec2>& spokes, const Vec2 normal_in_body, const double c,
                      const double s) {
  double most = 0.0;
  bool any = false;
  for (const Vec2 u : spokes) {
    const double v = dot(normal_in_body, u);
    if (v < 0.0) continue;
    const double least = v * c - std::abs(cross(normal_in_body, u)) * s;
    most = any ? std::max(most, least) : least;
    any = true;
  }
  return any ? most : -std::numeric_limits<double>::infinity();
}

Vec2 turned_back(const Rotation& rotation, const Vec2 a) {
  return rotate({rotation.cos, -rotation.sin}, a);
}

class Search {
 public:
  Search(const TurningBody& body, const ConvexSeparator& container, const double margin,
         const double bound, ContainmentScratch& scratch, int& placements)
      : body_(body),
        container_(container),
        margin_(margin),
        bound_(bound),
        scratch_(scratch),
        placements_(placements) {}

  std::optional<Placement> run() {
    branch_and_bound();
    if (!found_) return std::nullopt;
    refine();
    return best_;
  }

 private:
  // DISP turns some point by 2 sin(|turn| / 2) times the smallest circle's radius at least.
  [[nodiscard]] double least_by_turning(const double turn) const {
    return 2.0 * std::sin(0.5 * std::min(turn, std::numbers::pi)) * body_.circle.radius;
  }

  [[nodiscard]] double wanted() const { return bound_ * (1.0 - kContainmentTolerance); }

  void branch_and_bound() {
    const double ratio = 0.5 * bound_ / body_.circle.radius;
    const double widest = ratio < 1.0 ? 2.0 * std::asin(ratio) : std::numbers::pi;
    const double half = widest / kFirstIntervals;
    scratch_.heap.clear();
    try_angle(0.0);
    for (int k = 0; k < kFirstIntervals; ++k) consider((2 * k + 1) * half - widest, half);
    while (!scratch_.heap.empty()) {
      std::pop_heap(scratch_.heap.begin(), scratch_.heap.end(), later);
      const Interval interval = scratch_.heap.back();
      scratch_.heap.pop_back();
      if (interval.lower >= wanted()) return;
      const double quarter = 0.5 * interval.half;
      consider(interval.middle - quarter, quarter);
      consider(interval.middle + quarter, quarter);
    }
  }

  static bool later(const Interval& a, const Interval& b) {
    return a.lower != b.lower ? a.lower > b.lower : a.middle > b.middle;
  }

  // Takes the placement at the interval's middle if it is the best yet, and keeps the interval if a
  // better one may be in it.
  void consider(const double middle, const double half) {
    if (least_by_turning(std::max(0.0, std::abs(middle) - half)) >= wanted()) return;
    try_angle(middle);
    const double shift = least_by_turning(half);  // of the spokes, at most; also of DISP
    set_sides(std::cos(half), std::sin(half));
    const auto nearest = nearest_in_container(scratch_.farthest, scratch_.sides, wanted() + shift);
    if (!nearest) return;
    const double lower = std::max(nearest->distance - shift,
                                  least_by_turning(std::max(0.0, std::abs(middle) - half)));
    // Turns that move the spokes by less than the margin, which is for rounding, are all one.
    if (lower >= wanted() || shift < margin_) return;
    scratch_.heap.push_back({lower, middle, half});
    std::push_heap(scratch_.heap.begin(), scratch_.heap.end(), later);
  }

  // Whether the placement at this turn is the best yet. Leaves rotation_ and the moves at the turn.
  bool try_angle(const double turn) {
    ++placements_;
    const double theta = body_.pose.theta + turn;
    rotation_ = rotation_of(theta);
    std::vector<Vec2>& moves = scratch_.farthest.offsets;
    moves.resize(body_.spokes.size());
    for (std::size_t k = 0; k < moves.size(); ++k) {
      moves[k] = rotate(rotation_, body_.spokes[k]) - body_.at_pose[k];
    }
    scratch_.farthest.radius = least_by_turning(std::abs(turn));
    set_sides(1.0, 0.0);
    const auto nearest = nearest_in_container(scratch_.farthest, scratch_.sides, bound_);
    if (!nearest) return false;
    bound_ = nearest->distance;
    best_turn_ = turn;
    found_ = true;
    const Vec2 centre = body_.centre + nearest->point;
    best_ = {{centre - rotate(rotation_, body_.circle.centre), theta}, bound_};
    return true;
  }

  // Where the circle's centre may go, as half-planes for its move; relaxed to all turns within an
  // angle of given cosine and sine.
  void set_sides(const double cosine, const double sine) {
    scratch_.sides.clear();
    for (const HalfPlane& side : container_.sides) {
      const Vec2 normal = turned_back(rotation_, side.normal);
      const double taken = sine == 0.0 ? support(body_.spokes, normal)
                                       : lowest_support(body_.spokes, normal, cosine, sine);
      scratch_.sides.push_back(
          {side.normal, side.offset - margin_ - dot(side.normal, body_.centre) - taken});
    }
  }

  // Steps to either side of the best angle, halved when neither is better.
  void refine() {
    const double angle = bound_ / body_.circle.radius;  // that moves some point by the bound
    for (double step = kFirstTurnStep * angle; step > kLastTurnStep * angle;) {
      const double turn = best_turn_;
      if (!try_angle(turn - step) && !try_angle(turn + step)) step *= 0.5;
    }
  }

  const TurningBody& body_;
  const ConvexSeparator& container_;
  double margin_;
  double bound_;
  ContainmentScratch& scratch_;
  int& placements_;
  Rotation rotation_;
  Placement best_;
  double best_turn_ = 0.0;
  bool found_ = false;
};

}  // namespace

std::optional<NearestPoint> nearest_in_container(const FarthestPoint& farthest,
                                                 const std::span<const HalfPlane> sides,
                                                 const double bound) {
  const double reach = farthest.reach(bound);
  Vec2 point;
  for (std::size_t j = 0; j < sides.size(); ++j) {
    if (dot(sides[j].normal, point) <= sides[j].offset) continue;
    const std::optional<Stretch> stretch = stretch_on(sides, j, reach);
    if (!stretch) return std::nullopt;
    point = point_at(stretch->line, farthest.least_on(stretch->line, stretch->low, stretch->high));
  }
  const double distance = farthest.value(point);
  if (!(distance < bound)) return std::nullopt;
  return NearestPoint{point, distance};
}

void make_turning_body(const PieceSet& body, const Pose& pose, TurningBody& result) {
  result.pose = pose;
  result.circle = smallest_enclosing_circle(body.hull);
  const Rotation rotation = rotation_of(pose.theta);
  result.centre = rotate(rotation, result.circle.centre) + pose.t;
  result.spokes.clear();
  result.at_pose.clear();
  for (const Vec2 v : body.hull) {
    result.spokes.push_back(v - result.circle.centre);
    result.at_pose.push_back(rotate(rotation, result.spokes.back()));
  }
}

double least_way_in(const TurningBody& body, const ConvexSeparator& container) {
  double most = 0.0;
  for (const HalfPlane& side : container.sides) {
    most = std::max(
        most, support(body.at_pose, side.normal) + dot(side.normal, body.centre) - side.offset);
  }
  return most;
}

std::optional<Placement> nearest_placement(const TurningBody& body,
                                           const ConvexSeparator& container, const double margin,
                                           const double bound, ContainmentScratch& scratch,
                                           int& placements) {
  return Search(body, container, margin, bound, scratch, placements).run();
}

}  // namespace pdg
