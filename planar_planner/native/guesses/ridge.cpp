#include "ridge.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "planar_planner/native/paths/segment.hpp"
#include "tuning.hpp"

namespace planner {

using pdg::EdgeOwner;

namespace {

void add_edges(const PairHeader& pair, const EdgeOwner owner, const std::size_t edges,
               std::vector<PairAxis>& axes) {
  for (std::size_t edge = 0; edge < edges; ++edge)
    axes.push_back({pair.obstacle, pair.robot, static_cast<std::uint16_t>(edge), owner});
}

}  // namespace

void RidgeClimb::add_axes(const ConstraintView& list, std::vector<PairAxis>& axes) const {
  std::size_t at = 0;
  for (const PairHeader& pair : list.pairs) {
    if (pair.robot != kNode && closed(pair)) {
      const pdg::ConvexPiece& obstacle = tree_.piece(pair.obstacle);
      add_edges(pair, EdgeOwner::kObstacle, obstacle.edges.size(), axes);
      if (obstacle.vertex_count > 0)
        add_edges(pair, EdgeOwner::kRobot, problem_.robot.pieces[pair.robot].edges.size(), axes);
    }
    for (const pdg::Constraint& c : list.constraints.subspan(at, pair.count))
      axes.push_back({pair.obstacle, pair.robot, c.edge, c.owner});
    at += pair.count;
  }
}

void RidgeClimb::sort_axes(std::vector<PairAxis>& axes) {
  const auto key = [](const PairAxis& a) {
    return std::tuple(a.obstacle, a.robot, a.owner, a.edge);
  };
  std::sort(axes.begin(), axes.end(),
            [&](const PairAxis& a, const PairAxis& b) { return key(a) < key(b); });
  const auto same = [&](const PairAxis& a, const PairAxis& b) { return key(a) == key(b); };
  axes.erase(std::unique(axes.begin(), axes.end(), same), axes.end());
}

ScaledConfiguration RidgeClimb::moved(const ScaledConfiguration& from, const Step3& d) const {
  const double turn = problem_.rotation ? d[2] / problem_.robot.reach : 0.0;
  return {from.t + Vec2{d[0], d[1]}, from.theta + turn};
}

// Value and derivatives by t and theta of the axis for each vertex that it may be decided by
// (docs/method.md, "Labels").
template <class Visit>
void RidgeClimb::each_vertex(const PairAxis& axis, const Vec2 t, const Visit& visit) {
  ++statistics_.ridge_evaluations;
  const pdg::PosedPiece a = posed_.piece(axis.robot);
  const pdg::ConvexPiece& b = tree_.piece(axis.obstacle);
  if (axis.owner == EdgeOwner::kObstacle) {
    const pdg::Edge& edge = b.edges[axis.edge];
    const Vec2 n = edge.normal;
    const double shift = dot(n, t) - edge.offset;
    for (const Vec2 p : a.vertices) visit(dot(n, p) + shift, n, cross(p, n));
    return;
  }
  const Vec2 n = a.normals[axis.edge];
  const double offset = a.piece->edges[axis.edge].offset;
  for (const pdg::Edge& edge : b.edges) {
    const Vec2 u = edge.vertex - t;
    visit(dot(n, u) - offset, -n, cross(n, u));
  }
}

double RidgeClimb::value(const PairAxis& axis, const Vec2 t) {
  double least = INFINITY;
  each_vertex(axis, t, [&](const double at, Vec2, double) { least = std::min(least, at); });
  return least;
}

// Turning counts as the way of the robot's farthest point. Returns the least value.
double RidgeClimb::add_terms(const PairAxis& axis, const Vec2 t) {
  const double lever = problem_.rotation ? 1.0 / problem_.robot.reach : 0.0;
  double least = INFINITY;
  each_vertex(axis, t, [&](const double at, const Vec2 slope, const double turning) {
    terms_.push_back({at, {slope.x, slope.y, turning * lever}});
    least = std::min(least, at);
  });
  return least;
}

double RidgeClimb::add_best(const ScaledConfiguration& at, const std::span<const PairAxis> axes,
                            std::vector<PairAxis>& best) {
  posed_.turn_to(rotation_at(at.theta));
  double least = INFINITY;
  for (std::size_t first = 0, i = 0; first < axes.size(); first = i) {
    std::size_t widest = first;
    double most = -INFINITY;
    for (; i < axes.size() && axes[i].same_pair(axes[first]); ++i) {
      const double here = value(axes[i], at.t);
      if (here <= most) continue;
      most = here;
      widest = i;
    }
    best.push_back(axes[widest]);
    least = std::min(least, most);
  }
  return least;
}

void RidgeClimb::add_good(const ScaledConfiguration& at, const std::span<const PairAxis> axes,
                          std::vector<PairAxis>& good) {
  posed_.turn_to(rotation_at(at.theta));
  for (std::size_t first = 0, i = 0; first < axes.size(); first = i) {
    values_.clear();
    for (; i < axes.size() && axes[i].same_pair(axes[first]); ++i)
      values_.push_back(value(axes[i], at.t));
    const double most = *std::max_element(values_.begin(), values_.end());
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (values_[k] == most || values_[k] > kGood * most) good.push_back(axes[first + k]);
  }
}

// `linearise` fills terms_ at a configuration and returns the least of them.
template <class Linearise>
Height RidgeClimb::climb_by(ScaledConfiguration at, double radius, const Linearise& linearise) {
  const double roomy = kRoomy * radius;
  double clearance = linearise(at);
  std::swap(terms_, terms_here_);
  for (int i = 0; i < kClimbSteps && clearance < roomy && !terms_here_.empty(); ++i) {
    terms_here_.push_back({roomy, {}});  // no farther than that
    const MaxMinStep step = max_min_step(terms_here_, kSteepest / radius);
    if (!(step.least - clearance > kEnough * std::abs(step.least))) break;
    const ScaledConfiguration next = moved(at, step.d);
    const double there = linearise(next);
    if (there > clearance) {
      at = next;
      clearance = there;
      std::swap(terms_, terms_here_);
    } else {
      radius *= kShorterStep;
      terms_here_.pop_back();
    }
  }
  return {at, clearance};
}

Height RidgeClimb::climb(const ScaledConfiguration& from, const double radius,
                         const std::span<const PairAxis> axes) {
  return climb_by(from, radius, [&](const ScaledConfiguration& at) {
    best_.clear();
    const double least = add_best(at, axes, best_);
    terms_.clear();
    for (const PairAxis& axis : best_) add_terms(axis, at.t);
    return least;
  });
}

Height RidgeClimb::climb_all(const ScaledConfiguration& from, const double radius,
                             const std::span<const PairAxis> axes) {
  return climb_by(from, radius, [&](const ScaledConfiguration& at) {
    posed_.turn_to(rotation_at(at.theta));
    terms_.clear();
    double least = INFINITY;
    for (const PairAxis& axis : axes) least = std::min(least, add_terms(axis, at.t));
    return least;
  });
}

}  // namespace planner
