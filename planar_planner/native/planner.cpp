#include "planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace planner {

namespace {

// The listener is called at most this often.
constexpr double kListenerPeriod = 0.1;  // seconds
// The clock is read once in so many checks of the limits.
constexpr std::uint64_t kClockStride = 64;

double tune(const char* name, double value) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : value;
}
const double kBatch = tune("T_BATCH", 0.5);

}  // namespace

struct Planner::Query {
  Query(const Configuration& s, const Configuration& g, const Limits& l, const Listener& ear)
      : start(s), goal(g), limits(l), listener(ear) {}

  const Configuration& start;
  const Configuration& goal;
  const Limits& limits;
  const Listener& listener;
  Answer answer;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  double last_call = 0.0;
  std::uint64_t checks = 0;
  double resolution = 0.0;  // planner units
  std::array<std::uint64_t, 3> start_point{}, goal_point{};
  std::unique_ptr<ChannelSearch> search;

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  void conclude(const Verdict verdict, std::string reason, std::string decided_by) {
    answer.verdict = verdict;
    answer.reason = std::move(reason);
    answer.statistics.decided_by = std::move(decided_by);
  }
};

Planner::Planner(Scene scene) {
  const Stopwatch watch(preprocessing_);
  problem_ = make_problem(std::move(scene));
  tree_ = std::make_unique<ObstacleTree>(problem_.scene.obstacles, problem_.frame, problem_.walls);
  labeller_ = std::make_unique<Labeller>(problem_.robot, *tree_, statistics_);
  segments_ = std::make_unique<SegmentTest>(problem_, *labeller_, statistics_);
}

Answer Planner::solve(const Configuration& start, const Configuration& goal, const Limits& limits,
                      const Listener& listener) {
  Query query(start, goal, limits, listener);
  statistics_ = {};
  statistics_.seconds.preprocessing = std::exchange(preprocessing_, 0.0);
  if (!trivial_answer(query) && !cheap_move(query)) subdivide(query);
  std::string decided_by = std::move(query.answer.statistics.decided_by);
  statistics_.seconds.total = query.elapsed() + statistics_.seconds.preprocessing;
  statistics_.pairs_total = (tree_->piece_count() - tree_->wall_count() + tree_->untouched_polygons()) *
                            problem_.robot.body_pieces();
  query.answer.statistics = statistics_;
  query.answer.statistics.decided_by = std::move(decided_by);
  take_census(query.answer);
  return std::move(query.answer);
}

bool Planner::trivial_answer(Query& query) {
  for (const bool at_start : {true, false}) {
    const Placement p = placement(at_start ? query.start : query.goal);
    const std::string name = at_start ? "start" : "goal";
    if (p.state == PlacementState::kColliding || p.state == PlacementState::kOutside) {
      query.conclude(Verdict::kNoPath, "the " + name + " is not free", name);
      return true;
    }
  }
  return false;
}

// Straight, then by two legs: turn and move, in either order and by either sense of rotation.
bool Planner::cheap_move(Query& query) {
  const Stopwatch watch(statistics_.seconds.path);
  const Configuration& s = query.start;
  Configuration g = query.goal;
  g.theta = problem_.rotation ? nearest_turn(g.theta, s.theta) : s.theta;
  const std::vector<std::vector<Configuration>> tries = {
      {s, g}, {s, {s.x, s.y, g.theta}, g}, {s, {g.x, g.y, s.theta}, g}};
  for (const std::vector<Configuration>& path : tries) {
    if (first_uncertified(problem_, *segments_, path)) continue;
    query.answer.path = report_path(problem_, *segments_, path);
    query.conclude(Verdict::kPath, "certified path found",
                   path.size() == 2 ? "straight move" : "two-leg move");
    return true;
  }
  return false;
}

void Planner::prepare_subdivision(const Query& query) {
  const CellSpace space{problem_.domain, problem_.rotation, query.start.theta};
  if (subdivision_ && (space.rotation || subdivision_->space().fixed_theta == space.fixed_theta))
    return;
  subdivision_ = std::make_unique<Subdivision>(space, *labeller_, statistics_);
  faces_ = std::make_unique<FaceTest>(*subdivision_, *labeller_, statistics_);
}

std::array<std::uint64_t, 3> Planner::dyadic(const Configuration& q) const {
  const Domain& d = problem_.domain;
  const Vec2 t = to_planner(problem_, {q.x, q.y});
  const auto count = [](const double fraction) {
    const double clamped = std::clamp(fraction, 0.0, 1.0);
    const auto k = static_cast<std::uint64_t>(std::ldexp(clamped, kCoordinateBits));
    return std::min(k, kUnit - 1);
  };
  const double turn = q.theta / (2.0 * std::numbers::pi);
  return {count((t.x - d.low.x) / d.size.x), count((t.y - d.low.y) / d.size.y),
          problem_.rotation ? count(turn - std::floor(turn)) : 0};
}

void Planner::subdivide(Query& query) {
  prepare_subdivision(query);
  query.resolution = query.limits.resolution;  // the domain's half-extent is about 1
  query.start_point = dyadic(query.start);
  query.goal_point = dyadic(query.goal);
  query.search = std::make_unique<ChannelSearch>(*subdivision_, statistics_);
  query.search->reset(subdivision_->locate(query.start_point),
                      subdivision_->locate(query.goal_point));
  std::vector<CellId> channel;
  std::vector<Connector> connectors;
  while (!out_of_limits(query)) {
    ++statistics_.search_rounds;
    bool connected = false;
    {
      const Stopwatch watch(statistics_.seconds.search);
      connected = query.search->find(channel);
    }
    if (!connected)
      return query.conclude(Verdict::kNoPath,
                            "cells and faces proven to lie in C-obstacle separate start and goal",
                            "separation");
    if (query.search->passes_barrier(channel))
      return query.conclude(Verdict::kUndecided, "resolution reached", "");
    statistics_.channel_length = channel.size();
    if (refine(query, channel)) continue;
    if (!link_channel(query, channel, connectors)) continue;
    if (finish_path(query, channel, connectors)) return;
  }
}

// Splits MIXED cells of the channel, the largest first. False if there are none.
bool Planner::refine(Query& query, const std::vector<CellId>& channel) {
  float largest = 0.0F;
  for (const CellId id : channel)
    if (subdivision_->cell(id).label == Label::kMixed)
      largest = std::max(largest, subdivision_->cell(id).size);
  if (largest == 0.0F) return false;
  for (const CellId id : channel) {
    const Cell& cell = subdivision_->cell(id);
    if (cell.label != Label::kMixed || cell.size < static_cast<float>(kBatch) * largest) continue;
    if (subdivision_->divisible(id, query.resolution)) {
      split(query, id);
    } else {
      subdivision_->mark_exhausted(id);
      query.search->on_exhausted(id);
    }
    if (query.limits.max_cells <= subdivision_->leaves()) break;
  }
  return true;
}

void Planner::split(Query& query, const CellId cell) {
  {
    const Stopwatch watch(statistics_.seconds.search);
    query.search->before_split(cell);
  }
  subdivision_->split(cell);
  const Stopwatch watch(statistics_.seconds.search);
  const auto moved = [&](const CellId end, const std::array<std::uint64_t, 3>& point) {
    return end == cell ? subdivision_->locate(point) : end;
  };
  query.search->after_split(cell, moved(query.search->start(), query.start_point),
                            moved(query.search->goal(), query.goal_point));
}

// Proves the links of a solid channel. False if one failed: the graph has changed.
bool Planner::link_channel(Query& query, const std::vector<CellId>& channel,
                           std::vector<Connector>& connectors) {
  connectors.clear();
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    const CellId a = channel[i];
    const CellId b = channel[i + 1];
    const Link link = faces_->test(a, b);
    if (link.state == LinkState::kOpen) {
      connectors.push_back(link.connector);
    } else if (link.state == LinkState::kBlocked) {
      subdivision_->disconnect(a, b);
      query.search->on_disconnected(a, b);
      return false;
    } else {
      resolve_doubt(query, a, b);
      return false;
    }
  }
  return true;
}

// A face that stays mixed: split the larger neighbour; at the limit the link becomes a barrier.
void Planner::resolve_doubt(Query& query, const CellId a, const CellId b) {
  const bool a_larger = subdivision_->cell(a).size >= subdivision_->cell(b).size;
  const CellId first = a_larger ? a : b;
  const CellId second = a_larger ? b : a;
  for (const CellId cell : {first, second})
    if (subdivision_->cell(cell).label == Label::kStar &&
        subdivision_->divisible(cell, query.resolution))
      return split(query, cell);
  query.search->on_doubtful(a, b);
}

bool Planner::finish_path(Query& query, const std::vector<CellId>& channel,
                          const std::vector<Connector>& connectors) {
  const Stopwatch watch(statistics_.seconds.path);
  std::vector<Configuration> path =
      assemble_path(problem_, *subdivision_, channel, connectors, query.start, query.goal);
  if (const auto bad = first_uncertified(problem_, *segments_, path)) {
    // Free by construction, but too near to contact for the rounded waypoints: refine there.
    const Pose from = pose_of(problem_, path[*bad]);
    const Pose to = pose_of(problem_, path[*bad + 1]);
    const Configuration middle = configuration_of(
        problem_, {0.5 * (from.t + to.t), 0.5 * (from.theta + to.theta)});
    const CellId cell = subdivision_->locate(dyadic(middle));
    if (!subdivision_->cell(cell).solid() || !subdivision_->divisible(cell, query.resolution)) {
      query.conclude(Verdict::kUndecided, "the path found is too near to contact to certify", "");
      return true;
    }
    split(query, cell);
    return false;
  }
  shorten(problem_, *segments_, path);
  query.answer.path = report_path(problem_, *segments_, std::move(path));
  query.conclude(Verdict::kPath, "certified path found", "channel");
  return true;
}

bool Planner::out_of_limits(Query& query) {
  const Limits& limits = query.limits;
  statistics_.memory_bytes = subdivision_->bytes() + query.search->bytes();
  if (subdivision_->leaves() >= limits.max_cells) {
    query.conclude(Verdict::kUndecided, "cell limit reached", "");
    return true;
  }
  if (statistics_.memory_bytes >= limits.max_memory) {
    query.conclude(Verdict::kUndecided, "memory limit reached", "");
    return true;
  }
  if (query.checks++ % kClockStride != 0) return false;
  const double elapsed = query.elapsed();
  if (elapsed >= limits.timeout) {
    query.conclude(Verdict::kUndecided, "time limit reached", "");
    return true;
  }
  if (query.listener && elapsed - query.last_call >= kListenerPeriod) {
    query.last_call = elapsed;
    Answer census;
    take_census(census);
    const Progress progress{elapsed,
                            subdivision_->leaves(),
                            census.cells_by_label[0],
                            census.cells_by_label[1],
                            census.cells_by_label[2],
                            census.cells_by_label[3],
                            statistics_.channel_length,
                            statistics_.search_rounds};
    if (!query.listener(progress)) {
      query.conclude(Verdict::kUndecided, "interrupted", "");
      return true;
    }
  }
  return false;
}

void Planner::take_census(Answer& answer) const {
  answer.cells_by_label = {};
  if (!subdivision_) return;
  for (CellId id = 0; id < subdivision_->size(); ++id) {
    const Cell& cell = subdivision_->cell(id);
    if (!cell.leaf()) continue;
    ++answer.cells_by_label[static_cast<std::size_t>(cell.label)];
    const std::size_t level = std::size_t{cell.box.level[0]} + cell.box.level[1] + cell.box.level[2];
    if (answer.cells_by_level.size() <= level) answer.cells_by_level.resize(level + 1);
    ++answer.cells_by_level[level];
  }
}

Placement Planner::placement(const Configuration& q) {
  Placement out;
  if (problem_.reference_bounds) {
    const Rectangle& r = *problem_.reference_bounds;
    const double outside = std::max({r.low.x - q.x, q.x - r.high.x, r.low.y - q.y, q.y - r.high.y});
    if (outside > 0.0) {
      out.state = PlacementState::kOutside;
      out.reference = true;
      out.depth = outside;
      return out;
    }
  }
  const Pose pose = pose_of(problem_, q);
  ConstraintList root, rest;
  labeller_->root_list(root);
  pdg::Motion motion;
  motion.t = pose.t;
  motion.reach = std::max(problem_.domain.reach, pdg::norm(pose.t) * pdg::kRadiusPadding);
  motion.angle_factor = 1.0 + std::abs(q.theta);
  const pdg::PosedRobot& posed = labeller_->posed({std::cos(q.theta), std::sin(q.theta)});
  const LabelResult result = labeller_->label(motion, posed, view(root), rest);
  if (result.label != Label::kFull) {
    out.state = result.label == Label::kFree ? PlacementState::kFree : PlacementState::kContact;
    out.clearance = length_to_user(problem_, result.clearance);
    return out;
  }
  out.state = PlacementState::kColliding;
  const pdg::PosedPiece a = posed_piece(problem_.robot, posed, result.witness.robot);
  (void)a;
  out.depth = length_to_user(problem_, -result.separation);
  out.robot_polygon = problem_.robot.polygon_of_piece[result.witness.robot];
  const std::uint32_t polygon = tree_->polygon_of_piece(result.witness.obstacle);
  out.wall = polygon == kWall || polygon >= problem_.user_obstacles;
  out.obstacle = out.wall ? -1 : polygon;
  return out;
}

PathCheck Planner::check_path(std::vector<Configuration> path) {
  PathCheck check;
  const auto bad = first_uncertified(problem_, *segments_, path);
  if (bad) check.bad_segment = static_cast<std::int64_t>(*bad);
  if (!bad) check.least_clearance = report_path(problem_, *segments_, std::move(path)).least_clearance;
  return check;
}

}  // namespace planner
