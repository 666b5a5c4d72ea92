// A robot whose own origin lies far from its body: the query is answered about a point of the body,
// and the answer is given in the robot's own frame.
#include <algorithm>
#include <cmath>
#include <utility>

#include "limit_watch.hpp"
#include "planar_planner/native/configurations/reference_point.hpp"
#include "planner.hpp"
#include "reference_path.hpp"

namespace planner {

namespace {

bool touches_end(const std::optional<StopReason> reason) {
  return reason == StopReason::kStartTouchesObstacle ||
         reason == StopReason::kStartTouchesWorkspace ||
         reason == StopReason::kGoalTouchesObstacle || reason == StopReason::kGoalTouchesWorkspace;
}

}  // namespace

void Planner::prepare_about_body(const Ablation& ablation) {
  const bool in_workspace = problem_.given.box || problem_.given.workspace;
  if (!ablation.shift || !problem_.rotation || !in_workspace) return;
  const auto point = body_point(problem_.given.robot);
  if (!point) return;
  Problem shifted = problem_.given;
  shifted.robot = about_point(shifted.robot, *point);
  // Bounds of the robot's own origin are left out: an absence without them is one with them, and a
  // path has to keep within them.
  shifted.reference_bounds.reset();
  Ablation once = ablation;
  once.shift = false;
  once.layers = false;  // they are as good in the robot's own frame
  about_body_ = std::make_unique<Planner>(std::move(shifted), once);
  point_ = *point;
}

// Empty if the question has to be asked in the robot's own frame after all: an end is not free, or
// rounding keeps an answer about the body from being one about the robot's own frame.
std::optional<Answer> Planner::solve_about_body(const Configuration& start,
                                                const Configuration& goal, const Limits& limits,
                                                const Listener& listener) {
  const Goal own{std::in_place_type<Configuration>, goal};
  LimitWatch watch(limits, listener);
  Query query(
      start, own, nullptr, limits, [&] { return watch.elapsed(); },
      [&](const Usage& usage, const auto& progress) { return watch.check(usage, progress); });
  if (ends_settle_it(query, start, own) || query.in_contact || !query.legs.empty()) {
    layer_.reset();
    layers_.clear();
    return std::nullopt;
  }
  Planner& body = *about_body_;
  const double reach = std::max(std::max(std::abs(query.start.x), std::abs(query.start.y)),
                                std::max(std::abs(query.goal.x), std::abs(query.goal.y)));
  body.end_error_ = turning_error(point_, reach + pdg::norm(point_) + limits.contact_tolerance);
  Limits left = limits;
  left.timeout -= watch.elapsed();
  const Goal there{std::in_place_type<Configuration>, placed(point_, query.goal)};
  query.answer = body.solve(placed(point_, query.start), there, left, listener);
  query.stopped_by = query.answer.stopped_by;
  if (!take_over(query, start, goal)) return std::nullopt;
  by_body_ = true;
  Answer& answer = query.answer;
  if (answer.stop_reason == StopReason::kResolution) settle_resolution(query, start, own);
  remember(query, start, own);
  settle_lifted_ends(query, start, own);
  Statistics& all = answer.statistics;
  all.path_length = answer.path.length;
  all.path_turning = answer.path.turning;
  all.waypoints = answer.path.waypoints.size();
  all.segments_tested = body.statistics_.segments_tested;
  all.separation_evaluations = body.statistics_.separation_evaluations;
  all.seconds.preprocessing += std::exchange(preprocessing_, 0.0);
  all.seconds.total = watch.elapsed() + all.seconds.preprocessing;
  return std::move(answer);
}

// Makes the body's answer one about the robot's own frame and the user's own ends; false if
// rounding forbids.
bool Planner::take_over(Query& query, const Configuration& start, const Configuration& goal) {
  Planner& body = *about_body_;
  const std::optional<DecidedBy> by = query.answer.statistics.decided_by;
  switch (query.answer.verdict) {
    case Verdict::kPath:
      return retrace(query);
    case Verdict::kNoPath:
      // The ends are free; that they collide as they are placed about the body is rounding.
      if (by == DecidedBy::kStart || by == DecidedBy::kGoal) return false;
      if (!query.lifted) return true;
      body.last_.start = placed(point_, start);
      body.last_.goal.emplace<Configuration>(placed(point_, goal));
      body.confirm_absence(query, body.last_.start, body.last_.goal);
      return true;
    case Verdict::kUndecided:
      return !touches_end(query.answer.stop_reason);
  }
  return false;
}

bool Planner::retrace(Query& query) {
  Planner& body = *about_body_;
  const Stopwatch watch(query.clock, query.answer.statistics.seconds.path);
  const Terminator stop = [&] { return query.clock() >= query.limits.timeout; };
  auto path = reference_path(body.problem_, *body.segments_, point_, query.answer.path.waypoints,
                             query.start, query.goal, stop);
  if (!path) return false;
  // The bounds are convex: between two waypoints in them all places are.
  const auto out = [&](const Configuration& q) { return outside_bounds(problem_, q) > 0.0; };
  if (std::any_of(path->begin(), path->end(), out)) return false;
  query.answer.path = report_path(std::move(*path));
  return true;
}

}  // namespace planner
