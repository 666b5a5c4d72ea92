#include "goal_region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "convex_clip.hpp"
#include "pdg/native/geometry/predicates.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "planar_planner/native/world/pieces.hpp"
#include "scaled_configuration.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Exactly: does the closed convex part hold the point?
bool holds(const pdg::ConvexPolygon& part, const Vec2 p) {
  for (std::size_t i = 0; i < part.size(); ++i)
    if (pdg::orient2d(part[i], part[(i + 1) % part.size()], p) < 0) return false;
  return true;
}

// Exactly: is some edge's line, or a side of the rectangle, strictly between the two?
bool apart(const pdg::ConvexPolygon& part, const Rectangle& bounds, const Rectangle& r) {
  if (bounds.high.x < r.low.x || r.high.x < bounds.low.x || bounds.high.y < r.low.y ||
      r.high.y < bounds.low.y)
    return true;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Vec2 a = part[i];
    const Vec2 b = part[(i + 1) % part.size()];
    // The rectangle's corner that is farthest on the inner side of the edge.
    const Vec2 corner{b.y > a.y ? r.low.x : r.high.x, b.x > a.x ? r.high.y : r.low.y};
    if (pdg::orient2d(a, b, corner) < 0) return true;
  }
  return false;
}

}  // namespace

GoalRegion::GoalRegion(const ScaledProblem& problem, const GoalSet& set)
    : problem_(problem), angles_(set.angles) {
  if (angles_) {
    const std::uint64_t low = dyadic_point(problem, {0.0, 0.0, angles_->low})[kTheta];
    const double width = (angles_->high - angles_->low) / kTurn;
    const double units = std::ceil(std::ldexp(width, static_cast<int>(kCoordinateBits)));
    // Slack at either end, and for the rounding of the width: 3 u of a turn, 2^10 units.
    turns_.length = std::min(static_cast<std::uint64_t>(units) + 3 * kDyadicSlack, kUnit);
    turns_.begin = (low - kDyadicSlack) & (kUnit - 1);
  }
  const Domain& d = problem.domain;
  reach_ = {to_user(problem, d.low), to_user(problem, d.low + d.size)};
  if (problem.reference_bounds) {
    const Rectangle& r = *problem.reference_bounds;
    reach_ = {{std::max(reach_.low.x, r.low.x), std::max(reach_.low.y, r.low.y)},
              {std::min(reach_.high.x, r.high.x), std::min(reach_.high.y, r.high.y)}};
  }
  for (std::size_t p = 0; p < set.polygons.size(); ++p)
    for (pdg::ConvexPolygon& piece : planner_pieces(set.polygons.polygon(p))) {
      Part part;
      part.bounds = bounds_of(piece);
      part.reachable = clipped(piece, reach_);
      part.area = area_of(part.reachable);
      part.vertices = std::move(piece);
      area_ += part.area;
      parts_.push_back(std::move(part));
    }
}

bool GoalRegion::contains(const Vec2 p) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return holds(part.vertices, p); });
}

bool GoalRegion::contains(const Configuration& q) const {
  const bool turned = !angles_ || (angles_->low <= q.theta && q.theta <= angles_->high);
  return turned && contains(Vec2{q.x, q.y});
}

// The box in the user's units, rounded outwards.
Rectangle GoalRegion::around(const CellSpace& space, const CellBox& box) const {
  const Vec2 low = to_user(problem_, position_of(space, box.low[kX], box.low[kY]));
  const Vec2 high = to_user(problem_, position_of(space, box.high(kX), box.high(kY)));
  const double extent = length_to_user(problem_, space.domain.reach + pdg::norm(space.domain.size));
  const auto slack = [&](const double at) {
    return kCornerUnits * pdg::kUnitRoundoff * (std::abs(at) + extent);
  };
  return {{low.x - slack(low.x), low.y - slack(low.y)},
          {high.x + slack(high.x), high.y + slack(high.y)}};
}

bool GoalRegion::may_meet(const CellSpace& space, const CellBox& box) const {
  if (space.rotation && turns_.length < kUnit) {
    const std::uint64_t ahead = (box.low[kTheta] - turns_.begin) & (kUnit - 1);
    const std::uint64_t behind = (turns_.begin - box.low[kTheta]) & (kUnit - 1);
    if (ahead > turns_.length && behind > box.size(kTheta)) return false;
  }
  const Rectangle r = around(space, box);
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return !apart(part.vertices, part.bounds, r); });
}

// The middle of the longest stretch of goal angles there is in between.
std::optional<double> GoalRegion::angle_between(const double first, const double last) const {
  if (!angles_) return 0.5 * (first + last);
  double longest = -1.0;
  std::optional<double> best;
  auto turns = static_cast<std::int64_t>(std::floor((first - angles_->high) / kTurn));
  for (; angles_->low + static_cast<double>(turns) * kTurn <= last; ++turns) {
    const double shift = static_cast<double>(turns) * kTurn;
    const double begin = std::max(first, angles_->low + shift);
    const double end = std::min(last, angles_->high + shift);
    if (end < begin || end - begin <= longest) continue;
    longest = end - begin;
    best = std::clamp(0.5 * (begin + end) - shift, angles_->low, angles_->high);
  }
  return best;
}

double GoalRegion::nearest_angle(const double theta) const {
  if (!angles_) return theta;
  if (angles_->low <= theta && theta <= angles_->high) return theta;
  const double middle = 0.5 * (angles_->low + angles_->high);
  const double half = 0.5 * (angles_->high - angles_->low);
  const double off = std::remainder(theta - middle, kTurn);
  const double kept = std::abs(off) <= half ? half : (1.0 - kInwards) * half;
  return std::clamp(middle + std::clamp(off, -kept, kept), angles_->low, angles_->high);
}

void GoalRegion::append_point(std::vector<Configuration>& out, const Vec2 p,
                              const double theta) const {
  const Configuration q{p.x, p.y, theta};
  if (contains(q) && inside_rectangle(reach_, p)) out.push_back(q);
}

std::vector<Configuration> GoalRegion::inside(const CellSpace& space, const CellBox& box) const {
  std::vector<Configuration> out;
  const auto angle = space.rotation ? angle_between(radians_of_turns(box.low[kTheta]),
                                                    radians_of_turns(box.high(kTheta)))
                                    : space.fixed_theta;
  if (!angle) return out;
  const Rectangle r{to_user(problem_, position_of(space, box.low[kX], box.low[kY])),
                    to_user(problem_, position_of(space, box.high(kX), box.high(kY)))};
  append_point(out, {0.5 * r.low.x + 0.5 * r.high.x, 0.5 * r.low.y + 0.5 * r.high.y}, *angle);
  for (const Part& part : parts_) {
    if (out.size() >= kMostGuesses) break;
    if (apart(part.vertices, part.bounds, r)) continue;
    const pdg::ConvexPolygon common = clipped(part.reachable, r);
    if (common.empty()) continue;
    append_point(out, middle_of(common), *angle);
    // A part may be so narrow that rounding moves its middle out of it; its corners lie in it.
    if (out.empty())
      for (const Vec2 corner : common) append_point(out, corner, *angle);
  }
  return out;
}

std::vector<Configuration> GoalRegion::near(const Configuration& q) const {
  std::vector<Configuration> out;
  const double theta = problem_.rotation ? nearest_angle(q.theta) : q.theta;
  const Vec2 from{q.x, q.y};
  append_point(out, from, theta);
  for (const Part& part : parts_) {
    if (part.reachable.empty()) continue;
    const Vec2 middle = middle_of(part.reachable);
    const Vec2 nearest = nearest_point(part.reachable, from);
    append_point(out, nearest + kInwards * (middle - nearest), theta);
    append_point(out, middle, theta);
  }
  const auto way = [&](const Configuration& p) { return pdg::norm(Vec2{p.x, p.y} - from); };
  std::stable_sort(out.begin(), out.end(),
                   [&](const Configuration& a, const Configuration& b) { return way(a) < way(b); });
  if (out.size() > kMostGuesses) out.resize(kMostGuesses);
  return out;
}

std::optional<Configuration> GoalRegion::sample(const double u, const double v,
                                                const double w) const {
  double rest = u * area_;
  for (const Part& part : parts_) {
    if (rest >= part.area) {
      rest -= part.area;
      continue;
    }
    const Vec2 p = point_at(part.reachable, rest / part.area, v);
    const double theta = angles_ ? std::clamp(angles_->low + w * (angles_->high - angles_->low),
                                              angles_->low, angles_->high)
                                 : kTurn * w;
    std::vector<Configuration> out;
    append_point(out, p, theta);
    if (!out.empty()) return out.front();
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace planner
