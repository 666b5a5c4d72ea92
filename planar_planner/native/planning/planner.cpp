#include "planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "limit_watch.hpp"
#include "planar_planner/native/cells/census.hpp"
#include "planar_planner/native/configurations/reference_point.hpp"
#include "planar_planner/native/evidence/layer_evidence.hpp"
#include "planar_planner/native/guesses/goal_guesses.hpp"
#include "planar_planner/native/search/channel.hpp"
#include "planar_planner/native/search/goal_cells.hpp"
#include "planar_planner/native/search/search.hpp"
#include "planar_planner/native/tolerances.hpp"
#include "planar_planner/native/world/disc.hpp"
#include "reference_path.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

// Are a few configurations of a leg in collision? A certificate that must fail is not begun.
bool looks_blocked(const ScaledProblem& problem, CollisionHint& hint,
                   const std::vector<Configuration>& path) {
  for (const double s : kGlances)
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const ScaledConfiguration from = scaled(problem, path[i]);
      const ScaledConfiguration to = scaled(problem, path[i + 1]);
      if (hint.gap(between(from, to, s)) < 0.0) return true;
    }
  return false;
}

StopReason touches(const bool at_start, const bool workspace) {
  if (at_start)
    return workspace ? StopReason::kStartTouchesWorkspace : StopReason::kStartTouchesObstacle;
  return workspace ? StopReason::kGoalTouchesWorkspace : StopReason::kGoalTouchesObstacle;
}

}  // namespace

Planner::Planner(Problem given, const Ablation& ablation) {
  const Clock clock = steady_seconds;
  const Stopwatch watch(clock, preprocessing_);
  problem_ = make_scaled_problem(std::move(given), ablation);
  tree_ = std::make_unique<ObstacleTree>(all_obstacles(problem_), problem_.frame, problem_.walls,
                                         ablation.partition);
  labeller_ = std::make_unique<Labeller>(problem_.robot, *tree_, statistics_, ablation);
  segments_ = std::make_unique<SegmentTest>(problem_, *labeller_, statistics_);
  prepare_about_body(ablation);
}

Answer Planner::solve(const Configuration& start, const Goal& goal, const Limits& limits,
                      const Listener& listener) {
  by_body_ = false;
  layer_.reset();
  layers_.clear();
  const auto* const place = std::get_if<Configuration>(&goal);
  if (about_body_ && place != nullptr)
    if (auto answer = solve_about_body(start, *place, limits, listener)) return std::move(*answer);
  std::optional<GoalRegion> region;
  if (const auto* const set = std::get_if<GoalSet>(&goal)) region.emplace(problem_, *set);
  LimitWatch watch(limits, listener);
  Query query(
      start, goal, region ? &*region : nullptr, limits, [&] { return watch.elapsed(); },
      [&](const Usage& usage, const auto& progress) {
        if (usage.cells >= pause_) return std::optional(StopReason::kMaxCells);
        return watch.check(usage, progress);
      });
  statistics_ = {};
  statistics_.seconds.preprocessing = std::exchange(preprocessing_, 0.0);
  CollisionHint hint(problem_, *tree_);
  std::optional<FirstTry> first_try;
  if (!ends_settle_it(query, start, goal) &&
      (query.in_contact || !guess(query, hint, goal, listener, first_try)) &&
      !small_subdivision(query, start, goal, first_try ? &*first_try : nullptr))
    subdivide(query, first_try ? &*first_try : nullptr);
  if (query.answer.stop_reason == StopReason::kResolution) settle_resolution(query, start, goal);
  confirm_absence(query, start, goal);
  add_exact_legs(query);
  remember(query, start, goal);
  settle_lifted_ends(query, start, goal);
  complete_answer(query);
  return std::move(query.answer);
}

Answer Planner::solve_certified(const Configuration& start, const Goal& goal, const Limits& limits,
                                const Listener& listener) {
  Answer answer = solve(start, goal, limits, listener);
  if (answer.verdict != Verdict::kPath || layer_) return answer;
  Evidence evidence;
  begin_path(evidence);
  for (const double share : {1.0, kClosestShare}) {
    last_.share = share;
    answer.to_be_checked = share < 1.0;
    if (collect_segments(problem_, *tree_, share, evidence)) return answer;
  }
  answer.to_be_checked = false;
  if (exact_instead(answer, start, goal)) return answer;
  last_ = {Verdict::kUndecided, std::nullopt, start, goal, {}, 1.0, {}};
  answer.exact.clear();
  answer.verdict = Verdict::kUndecided;
  answer.stop_reason = StopReason::kNoEvidence;
  answer.ends_moved = false;
  answer.path = {};
  answer.statistics.decided_by.reset();
  answer.statistics.path_length = 0.0;
  answer.statistics.path_turning = 0.0;
  answer.statistics.waypoints = 0;
  return answer;
}

// What is certified with rounding, before there are cells.
bool Planner::guess(Query& query, CollisionHint& hint, const Goal& goal, const Listener& listener,
                    std::optional<FirstTry>& first_try) {
  const Ablation& parts = problem_.ablation;
  return (parts.cheap && (cheap_move(query, hint) || disc_answer(query, goal, listener))) ||
         (parts.probe && probe(query, hint, first_try));
}

// A few cells first, which tell most scenes and show where a way is shut; then the exact decision,
// which costs no more in scenes where everything fits exactly; all cells only after that.
bool Planner::small_subdivision(Query& query, const Configuration& start, const Goal& goal,
                                FirstTry* const first_try) {
  if (problem_.rotation || !problem_.ablation.layers || query.limits.max_cells <= kCellsBeforeLayer)
    return false;
  pause_ = kCellsBeforeLayer;
  subdivide(query, first_try);
  pause_ = kNoPause;
  if (query.stopped_by != StopReason::kMaxCells) return true;
  query.stopped_by.reset();
  return layer_answer(query, start, goal);
}

// A colliding end has no path; one in contact is moved off by the contact tolerance, if it allows.
bool Planner::ends_settle_it(Query& query, const Configuration& start, const Goal& goal) {
  for (Configuration* const end : {&query.start, &query.goal}) {
    if (end == &query.goal && query.region != nullptr) break;
    const bool at_start = end == &query.start;
    const Placement p = placement(*end);
    if (p.state == PlacementState::kFree) continue;
    // Rounded arithmetic tells no more of an end in contact; exact arithmetic may.
    if (p.state == PlacementState::kContact && layer_answer(query, start, goal)) return true;
    if (p.state == PlacementState::kContact && leave_contact(query, start, goal, at_start))
      continue;
    if (p.state != PlacementState::kOutside && p.depth <= query.limits.contact_tolerance &&
        query.limits.contact_tolerance > 0.0) {
      if (const auto moved = lift_off(problem_, *segments_, *end, query.limits.contact_tolerance)) {
        *end = *moved;
        query.lifted = true;
        continue;
      }
    }
    // Where rounding cannot tell touching from penetration, no path can be certified from here, but
    // its absence can.
    if (p.state == PlacementState::kContact) {
      if (!query.in_contact) query.in_contact = touches(at_start, p.wall);
      continue;
    }
    query.decide(Verdict::kNoPath, at_start ? DecidedBy::kStart : DecidedBy::kGoal);
    return true;
  }
  return false;
}

bool Planner::cheap_move(Query& query, CollisionHint& hint) {
  const Stopwatch watch(query.clock, statistics_.seconds.path);
  const Terminator stop = [&] { return query.clock() >= query.limits.timeout; };
  if (query.region == nullptr) return cheap_move_to(query, hint, query.goal, stop);
  const std::vector<Configuration> goals =
      near_goals(*query.region, *segments_, problem_, query.start);
  return std::any_of(goals.begin(), goals.end(), [&](const Configuration& goal) {
    return cheap_move_to(query, hint, goal, stop);
  });
}

// Straight, then by two legs: turn and move, in either order.
bool Planner::cheap_move_to(Query& query, CollisionHint& hint, const Configuration& goal,
                            const Terminator& stop) {
  const Configuration& s = query.start;
  Configuration g = goal;
  g.theta = problem_.rotation ? nearest_turn(g.theta, s.theta) : s.theta;
  const std::vector<std::vector<Configuration>> tries = {
      {s, g}, {s, {s.x, s.y, g.theta}, g}, {s, {g.x, g.y, s.theta}, g}};
  for (const std::vector<Configuration>& path : tries)
    if (!looks_blocked(problem_, hint, path) &&
        !first_uncertified(problem_, *segments_, path, stop))
      return conclude_path(query, path,
                           path.size() == 2 ? DecidedBy::kStraightMove : DecidedBy::kTwoLegMove);
  return false;
}

bool Planner::conclude_path(Query& query, std::vector<Configuration> path, const DecidedBy by) {
  query.answer.path = report_path(std::move(path));
  query.decide(Verdict::kPath, by);
  return true;
}

// The first try; it goes on beside the cells if it has not found a path by itself.
bool Planner::probe(Query& query, CollisionHint& hint, std::optional<FirstTry>& first_try) {
  const Terminator stop = [&] { return query.clock() >= query.limits.timeout; };
  const std::vector<Configuration> goals =
      query.region == nullptr ? std::vector{query.goal}
                              : free_goals(*query.region, hint, problem_, query.start);
  if (goals.empty()) return false;
  first_try.emplace(problem_, *tree_, *segments_, hint, statistics_, query.clock, query.start,
                    goals);
  const std::uint64_t most = kTryWork + kTryWorkPerVertex * all_obstacles(problem_).points();
  std::vector<Configuration> path;
  while (path.empty() && first_try->work() < most && !stop() &&
         (first_try->promising() || first_try->work() < kLeastTryWork))
    path = first_try->go_on(std::min(kLeastTryWork, most - first_try->work()), stop);
  return !path.empty() && conclude_path(query, std::move(path), DecidedBy::kFirstTry);
}

bool Planner::disc_answer(Query& query, const Goal& goal, const Listener& listener) {
  if (!std::exchange(disc_prepared_, true)) {
    if (auto discs = disc_problems(problem_)) {
      Ablation parts = problem_.ablation;
      parts.layers = false;  // a certificate about a disc is one of cells
      disc_round_ = std::make_unique<Planner>(std::move(discs->round), parts);
      disc_inside_ = std::make_unique<Planner>(std::move(discs->inside), parts);
      disc_round_->end_error_ = disc_inside_->end_error_ = end_error_;
    }
  }
  if (!disc_round_) return false;
  if (ask_disc(*disc_inside_, query, goal, listener).verdict == Verdict::kNoPath) {
    query.decide(Verdict::kNoPath, DecidedBy::kDisc);
    return true;
  }
  if (query.stopped_by) return true;
  Answer round = ask_disc(*disc_round_, query, goal, listener);
  if (round.verdict != Verdict::kPath) return query.stopped_by.has_value();
  std::vector<Configuration>& path = round.path.waypoints;
  for (Configuration& q : path) q.theta = query.start.theta;
  path.push_back(query.region == nullptr ? query.goal : path.back());
  const double angle =
      query.region == nullptr ? query.goal.theta : query.region->nearest_angle(query.start.theta);
  path.back().theta = nearest_turn(angle, query.start.theta);
  const Terminator never = [] { return false; };
  if (first_uncertified(problem_, *segments_, path, never)) return false;
  return conclude_path(query, std::move(path), DecidedBy::kDisc);
}

// Its work counts as the query's; its interruption ends the query. A disc has no angle to mind.
Answer Planner::ask_disc(Planner& disc, Query& query, const Goal& goal, const Listener& listener) {
  Limits limits = query.limits;
  limits.max_cells = std::min(limits.max_cells, kDiscCells);
  limits.timeout -= query.clock();
  Goal place = Configuration{query.goal.x, query.goal.y, 0.0};
  if (const auto* const set = std::get_if<GoalSet>(&goal))
    place = GoalSet{set->polygons, std::nullopt};
  Answer answer = disc.solve({query.start.x, query.start.y, 0.0}, place, limits, listener);
  statistics_ += answer.statistics;
  const bool tried_enough =
      limits.max_cells < query.limits.max_cells && answer.stopped_by == StopReason::kMaxCells;
  if (answer.stopped_by && !tried_enough) {
    query.leave_undecided(*answer.stopped_by);
    query.stopped_by = answer.stopped_by;
  }
  return answer;
}

void Planner::prepare_subdivision(const Query& query) {
  const CellSpace space{problem_.domain, problem_.rotation, query.start.theta};
  if (subdivision_ && (space.rotation || subdivision_->space().fixed_theta == space.fixed_theta))
    return;
  subdivision_ = std::make_unique<Subdivision>(space, *labeller_, statistics_, crossing_cost);
  faces_ = std::make_unique<FaceTest>(*subdivision_, *labeller_, statistics_);
}

void Planner::subdivide(Query& query, FirstTry* const first_try) {
  prepare_subdivision(query);
  Search(problem_, *tree_, *subdivision_, *faces_, *segments_, statistics_, query, first_try).run();
}

// Every leaf that the exact configuration can lie in.
std::vector<CellId> Planner::leaves_of(const Configuration& q) const {
  const double error = std::ldexp(end_error_, problem_.frame.exponent) /
                       std::min(problem_.domain.size.x, problem_.domain.size.y);
  const double units = std::ldexp(std::min(error, 1.0), static_cast<int>(kCoordinateBits) + 1);
  return subdivision_->leaves_near(dyadic_point(problem_, q),
                                   kDyadicSlack + static_cast<std::uint64_t>(units));
}

// Every leaf that may hold a goal.
std::vector<CellId> Planner::leaves_of_goal(const Goal& goal) const {
  if (const auto* const set = std::get_if<GoalSet>(&goal))
    return leaves_that_may_meet(GoalRegion(problem_, *set), *subdivision_);
  return leaves_of(std::get<Configuration>(goal));
}

// A proof of absence was found for the ends as they were placed: rounded, or lifted off a contact.
// It is concluded only if it holds for the user's own, whether those are free or in contact: every
// leaf that one can lie in is cut off from every leaf that the other can lie in.
void Planner::confirm_absence(Query& query, const Configuration& start, const Goal& goal) const {
  const Answer& answer = query.answer;
  if (answer.verdict != Verdict::kNoPath) return;
  const std::optional<DecidedBy> by = answer.statistics.decided_by;
  const bool by_cells = by == DecidedBy::kSeparation;
  const bool separated =
      by_cells && !subdivision_->connected(leaves_of(start), leaves_of_goal(goal));
  const bool own_ends = !query.lifted || by == DecidedBy::kStart || by == DecidedBy::kGoal;
  if (by_cells ? separated : own_ends) return;
  query.leave_undecided(StopReason::kMovedEnds);
}

// A lifted end stands for the user's: its path gets a first or last leg within the tolerance.
void Planner::settle_lifted_ends(Query& query, const Configuration& start, const Goal& goal) const {
  if (!query.lifted) return;
  std::vector<Configuration>& path = query.answer.path.waypoints;
  if (path.empty()) return;
  const auto same = [](const Configuration& a, const Configuration& b) {
    return a.x == b.x && a.y == b.y;
  };
  if (!same(query.start, start)) path.insert(path.begin(), start);
  if (const auto* const own = std::get_if<Configuration>(&goal); own && !same(query.goal, *own))
    path.push_back({own->x, own->y, path.back().theta});
  query.answer.path = report_path(std::move(path));
  query.answer.ends_moved = true;
}

void Planner::complete_answer(Query& query) {
  Answer& answer = query.answer;
  statistics_.seconds.total = query.clock() + statistics_.seconds.preprocessing;
  statistics_.pairs_total +=
      (tree_->piece_count() - tree_->wall_count() + tree_->untouched_polygons()) *
      problem_.robot.body_pieces();
  statistics_.pairs_touched += labeller_->pairs_touched();
  statistics_.decided_by = answer.statistics.decided_by;
  statistics_.path_length = answer.path.length;
  statistics_.path_turning = answer.path.turning;
  statistics_.waypoints = answer.path.waypoints.size();
  if (subdivision_) {
    CellCounts counts = take_census(*subdivision_);
    statistics_.cells = subdivision_->size();
    statistics_.cells_by_label = counts.by_label;
    statistics_.cells_by_level = std::move(counts.by_level);
  }
  answer.statistics = statistics_;
  answer.stopped_by = query.stopped_by;
}

void Planner::remember(const Query& query, const Configuration& start, const Goal& goal) {
  const Answer& answer = query.answer;
  last_ = {answer.verdict, answer.statistics.decided_by, start, goal, answer.path.waypoints, 1.0,
           answer.exact};
}

Evidence Planner::evidence() {
  if (layer_)
    return layer_->chain.empty() ? path_evidence(problem_, layer_->layer, layer_->waypoints)
                                 : chain_evidence(layer_->layer, layer_->chain);
  if (by_body_ && last_.verdict == Verdict::kNoPath) return about_body_->evidence();
  Evidence out;
  if (last_.verdict == Verdict::kPath) {
    begin_path(out);
    if (collect_segments(problem_, *tree_, last_.share, out)) out.kind = ClaimKind::kPath;
    collect_near_polygons(problem_, out);
  } else if (last_.verdict == Verdict::kNoPath && last_.decided_by == DecidedBy::kDisc) {
    out = disc_inside_->evidence();
    if (out.kind == ClaimKind::kSeparation) out.kind = ClaimKind::kDisc;
    out.disc_piece = problem_.robot.inner_piece;
    return out;
  } else if (last_.verdict == Verdict::kNoPath && last_.decided_by == DecidedBy::kSeparation) {
    out.barrier = find_barrier(*subdivision_, faces_->blocked(), leaves_of(last_.start),
                               leaves_of_goal(last_.goal));
    if (!out.barrier.start_side.empty()) out.kind = ClaimKind::kSeparation;
  } else if (last_.verdict == Verdict::kNoPath) {
    out.kind = ClaimKind::kEnd;
    out.at_goal = last_.decided_by == DecidedBy::kGoal;
    const Configuration& q = out.at_goal ? std::get<Configuration>(last_.goal) : last_.start;
    const Placement p = place(problem_, *tree_, *labeller_, q);
    if (p.state == PlacementState::kContact)  // which exact arithmetic has decided
      if (const auto exact = place_exactly(problem_, q); exact && exact->in)
        return end_evidence(exact->layer, *exact->in, out.at_goal);
    out.out_of_bounds = p.state == PlacementState::kOutside;
    out.witness = p.witness;
  }
  out.robot_names = robot_names(problem_.robot);
  out.obstacle_names = obstacle_names(*tree_);
  if (out.kind == ClaimKind::kPath) prove_exact_legs(layers_, out);
  collect_polygons(out);
  return out;
}

double Planner::least_clearance() {
  if (last_.verdict != Verdict::kPath || layer_) return 0.0;
  if (by_body_)
    return reference_path_clearance(about_body_->problem_, *about_body_->tree_, point_,
                                    last_.waypoints);
  return path_clearance(problem_, *tree_, last_.waypoints);
}

Crossing Planner::thinnest_wall() {
  if (last_.verdict != Verdict::kNoPath) return {};
  if (by_body_) {
    Crossing crossing = about_body_->thinnest_wall();
    for (Configuration& q : crossing.way) q = placed_back(point_, q);
    return crossing;
  }
  if (last_.decided_by == DecidedBy::kDisc) return disc_inside_->thinnest_wall();
  if (last_.decided_by != DecidedBy::kSeparation) return {};
  return find_thinnest_wall(
      problem_, *subdivision_, leaves_of(last_.start), leaves_of_goal(last_.goal),
      [this](const Configuration& q) { return place(problem_, *tree_, *labeller_, q).depth; });
}

CellTable Planner::cells() const {
  if (by_body_) return about_body_->cells();
  return subdivision_ ? tabulate(problem_, *subdivision_) : CellTable{};
}

double Planner::tolerated_error() const {
  const double unused = kUnusedErrorUnits * pdg::kUnitRoundoff * problem_.domain.reach;
  return length_to_user(problem_, unused / kMovedByCoordinates);
}

// Where rounded arithmetic leaves it open whether the robot touches or overlaps, exact arithmetic
// may tell.
Placement Planner::placement(const Configuration& q) {
  Placement out = place(problem_, *tree_, *labeller_, q);
  if (out.state != PlacementState::kContact || !problem_.ablation.layers) return out;
  const auto exact = place_exactly(problem_, q);
  if (!exact || !exact->in) return out;
  const ChainLink in = *exact->in;
  out.state = PlacementState::kColliding;
  out.exact = true;
  out.depth = exact->depth;
  out.wall = in < 0;
  out.obstacle = -1;
  if (in < 0) return out;
  const OpenSum& sum = exact->layer.sums[static_cast<std::size_t>(in)];
  const std::uint32_t polygon = exact->layer.obstacles[sum.obstacle_piece].polygon;
  out.robot_polygon = exact->layer.robot[sum.robot_piece].polygon;
  out.wall = polygon >= problem_.given.obstacles.size();
  if (!out.wall) out.obstacle = static_cast<std::int64_t>(polygon);
  return out;
}

PathCheck Planner::check_path(std::vector<Configuration> path) {
  PathCheck check;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool turns = !problem_.rotation && path[i].theta != path[0].theta;
    const bool alone = path.size() == 1 && !segments_->is_free(scaled(problem_, path[i]));
    if (outside_bounds(problem_, path[i]) == 0.0 && !turns && !alone) continue;
    check.bad_segment = i == 0 ? 0 : static_cast<std::int64_t>(i) - 1;
    return check;
  }
  const Terminator never = [] { return false; };
  const auto bad = first_uncertified(problem_, *segments_, path, never);
  if (bad) check.bad_segment = static_cast<std::int64_t>(*bad);
  if (!bad) check.least_clearance = path_clearance(problem_, *tree_, path);
  return check;
}

}  // namespace planner
