#include "search.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tuning.hpp"

namespace planner {

Search::Search(const ScaledProblem& problem, ObstacleTree& tree, Subdivision& subdivision,
               FaceTest& faces, SegmentTest& segments, Statistics& statistics, Query& query,
               FirstTry* const first_try)
    : problem_(problem),
      tree_(tree),
      subdivision_(subdivision),
      faces_(faces),
      segments_(segments),
      statistics_(statistics),
      query_(query),
      start_point_(dyadic_point(problem, query.start)),
      goal_point_(dyadic_point(problem, query.goal)),
      channels_(subdivision, statistics),
      ridge_(problem, tree, subdivision, segments, statistics),
      survey_(problem, tree, subdivision, segments, statistics),
      first_try_(first_try) {
  work_before_ = cells_work();
  if (query.region != nullptr) goals_.emplace(*query.region, subdivision);
}

void Search::begin_search() {
  subdivision_.clear_exhausted();
  const CellId start = subdivision_.locate(start_point_);
  if (goals_)
    channels_.reset(start, goals_->wanted());
  else
    channels_.reset(start, subdivision_.locate(goal_point_));
}

// Can the start's leaf reach one that may hold a goal? By a flood fill.
bool Search::goal_connected() const {
  const CellId start = channels_.start();
  if (!goals_) return subdivision_.connected(start, channels_.goal());
  return subdivision_.connected({&start, 1}, goals_->all());
}

void Search::run() {
  begin_search();
  std::vector<CellId> channel;
  while (!stop()) {
    ++statistics_.search_rounds;
    if (goals_ && goals_->due()) take_back_goals();
    bool connected = false;
    {
      const Stopwatch watch(query_.clock, statistics_.seconds.search);
      if (!problem_.ablation.incremental) channels_.rebuild();
      connected = channels_.find(channel);
    }
    if (!connected && !goal_connected())
      return query_.decide(Verdict::kNoPath, DecidedBy::kSeparation);
    if (!connected && take_back_goals()) continue;
    if (!connected && goals_ && goals_->only_given_up(channels_.start()))
      return query_.leave_undecided(StopReason::kResolution);
    if (!connected) {
      // Never seen, and counted, so that the tests would: the proof does not lean on mended trees.
      ++statistics_.search_rebuilds;
      channels_.rebuild();
      if (!channels_.find(channel)) return query_.leave_undecided(StopReason::kLostChannel);
    }
    if (channels_.passes_barrier(channel)) {
      // Mended distances are not exact: only a search from scratch can say that every channel does.
      channels_.rebuild();
      channels_.find(channel);
      if (channels_.passes_barrier(channel) && take_back_goals()) continue;
      if (channels_.passes_barrier(channel)) return query_.leave_undecided(StopReason::kResolution);
    }
    statistics_.channel_length = channel.size();
    if (try_trees() || try_ridge(channel)) return;
    if (split_stuck(channel)) {
      if (query_.answer.verdict == Verdict::kPath) return;
      continue;
    }
    const bool everywhere = !problem_.ablation.guided && !solid(channel);
    if (split_mixed(everywhere ? all_cells() : channel)) continue;
    if (!link(channel)) continue;
    if (finish(channel)) return;
  }
}

bool Search::solid(const std::vector<CellId>& channel) const {
  return std::all_of(channel.begin(), channel.end(),
                     [&](const CellId id) { return subdivision_.cell(id).solid(); });
}

// Level by level there is no channel: every leaf is as good as any other.
std::vector<CellId> Search::all_cells() const {
  std::vector<CellId> all(subdivision_.size());
  std::iota(all.begin(), all.end(), CellId{0});
  std::erase_if(all, [&](const CellId id) { return subdivision_.cell(id).exhausted; });
  return all;
}

// Splits the largest MIXED cells among these. False if there are none.
bool Search::split_mixed(const std::vector<CellId>& channel) {
  float largest = 0.0F;
  for (const CellId id : channel)
    if (subdivision_.cell(id).label == Label::kMixed)
      largest = std::max(largest, subdivision_.cell(id).size);
  if (largest == 0.0F) return false;
  for (const CellId id : channel) {
    const Cell& cell = subdivision_.cell(id);
    if (cell.label != Label::kMixed || cell.size < kBatch * largest) continue;
    if (stop()) break;
    if (subdivision_.divisible(id, query_.limits.resolution))
      split(id);
    else
      exhaust(id);
  }
  return true;
}

void Search::split(const CellId cell) {
  {
    const Stopwatch watch(query_.clock, statistics_.seconds.search);
    channels_.before_split(cell);
  }
  faces_.forget(cell);
  survey_.forget(cell);
  const CellId upper = halve(cell);
  const Stopwatch watch(query_.clock, statistics_.seconds.search);
  const auto moved = [&](const CellId end, const std::array<std::uint64_t, 3>& point) {
    return end == cell ? subdivision_.locate(point) : end;
  };
  if (goals_) goals_->after_split(cell, upper);
  channels_.after_split(cell, upper, moved(channels_.start(), start_point_),
                        goals_ ? kNoCell : moved(channels_.goal(), goal_point_));
}

CellId Search::halve(const CellId cell) {
  const Stopwatch watch(query_.clock, statistics_.seconds.labelling);
  return subdivision_.split(cell);
}

void Search::exhaust(const CellId cell) {
  subdivision_.mark_exhausted(cell);
  channels_.on_exhausted(cell);
}

// Shall all links of the next channel be tested, or only those up to the first that fails? Along a
// long way finding the channel again after each failure costs the square of its length; near a
// bottleneck that is about to close the others are split in vain, and mending the search for them
// costs far more than for one. So all are tested whenever testing single ones has cost the search
// as many steps as testing all did the last time. Steps of the search only: going along the channel
// is not counted, which tells on channels of 10^5 cells (docs/benchmarks.md).
bool Search::time_for_all_links() {
  const std::uint64_t steps = statistics_.search_expansions;
  const std::uint64_t since = steps - std::exchange(link_steps_.before, steps);
  if (link_steps_.tested_all) link_steps_.after_all = since;
  link_steps_.after_single = link_steps_.tested_all ? 0 : link_steps_.after_single + since;
  link_steps_.tested_all = link_steps_.after_single >= link_steps_.after_all;
  return link_steps_.tested_all;
}

Link Search::test_face(const CellId a, const CellId b) {
  const Stopwatch watch(query_.clock, statistics_.seconds.faces);
  return faces_.test(a, b);
}

// Proves the links of a solid channel. False if some failed, or a limit struck: the graph has
// changed.
bool Search::link(const std::vector<CellId>& channel) {
  connectors_.clear();
  const bool all = time_for_all_links();
  std::vector<std::pair<CellId, CellId>> blocked, doubtful;
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    if (stop()) return false;
    const Link link = test_face(channel[i], channel[i + 1]);
    if (link.state == LinkState::kOpen) {
      connectors_.push_back(link.connector);
      continue;
    }
    (link.state == LinkState::kBlocked ? blocked : doubtful)
        .emplace_back(channel[i], channel[i + 1]);
    if (!all) break;
  }
  for (const auto& [a, b] : blocked) {
    subdivision_.disconnect(a, b);
    channels_.on_disconnected(a, b);
  }
  resolve_doubts(doubtful);
  return blocked.empty() && doubtful.empty();
}

// In the order of the channel; a link to a cell that has just been split is no more what it was.
void Search::resolve_doubts(const std::vector<std::pair<CellId, CellId>>& links) {
  CellId last_split = kNoCell;
  for (const auto& [a, b] : links)
    if (a != last_split) last_split = resolve_doubt(a, b);
}

// A face that stays mixed: split the larger STAR neighbour, the cell returned; at the limit the
// link is a barrier.
CellId Search::resolve_doubt(const CellId a, const CellId b) {
  const bool a_larger = subdivision_.cell(a).size >= subdivision_.cell(b).size;
  for (const CellId cell : {a_larger ? a : b, a_larger ? b : a}) {
    if (!subdivision_.divisible(cell, query_.limits.resolution)) continue;
    split(cell);
    return cell;
  }
  channels_.on_doubtful(a, b);
  return kNoCell;
}

// A free goal in the channel's last cell. True without a region.
bool Search::pick_goal(const CellId cell) {
  if (!goals_) return true;
  for (const Configuration& q :
       goals_->region().inside(subdivision_.space(), subdivision_.cell(cell).box)) {
    if (!segments_.is_free(scaled(problem_, q))) continue;
    query_.goal = q;
    return true;
  }
  return false;
}

// The halves of a solid cell may tell whether it holds a free goal.
void Search::drop_goal(GoalCells& goals, const CellId cell) {
  if (subdivision_.divisible(cell, query_.limits.resolution)) {
    split(cell);
  } else {
    goals.give_up(cell);
    channels_.on_goal_lost(cell);
  }
  if (goals.note_vain_goal()) channels_.rebuild();
}

// True if there are more goals to search for now.
bool Search::take_back_goals() {
  if (!goals_ || !goals_->take_back()) return false;
  channels_.rebuild();
  return true;
}

// Certifies the channel's path. False if it has to be refined first.
bool Search::finish(const std::vector<CellId>& channel) {
  if (GoalCells* const goals = goals_ ? &*goals_ : nullptr;
      goals != nullptr && !pick_goal(channel.back())) {
    drop_goal(*goals, channel.back());
    return false;
  }
  const Stopwatch watch(query_.clock, statistics_.seconds.path);
  const Terminator terminator = [this] { return stop(); };
  std::vector<CellId> owners;
  std::vector<Configuration> path = assemble_path(problem_, subdivision_, channel, connectors_,
                                                  query_.start, query_.goal, owners);
  CollisionHint hint(problem_, tree_);
  const auto bad = certify_shortened(problem_, tree_, segments_, hint, path, terminator);
  if (query_.stopped_by) return true;
  if (bad) {
    // Free by construction, but too near to contact for the rounded waypoints: smaller cells have
    // guards that lie better.
    const CellId cell = owners[*bad];
    if (subdivision_.divisible(cell, query_.limits.resolution))
      split(cell);
    else
      exhaust(cell);
    return false;
  }
  conclude_path(std::move(path), DecidedBy::kChannel);
  return true;
}

// Work of cells and search so far, in nanoseconds on one machine (tuning.hpp).
std::uint64_t Search::cells_work() const {
  const std::uint64_t tried = first_try_ == nullptr ? 0 : first_try_->evaluations();
  return kLabelWork * statistics_.labelled_cells + kStepWork * statistics_.search_expansions +
         kSeparationWork * (statistics_.separation_evaluations - tried);
}

// The first try takes turns with the cells: it does a part of the work that they have done since
// its last turn, a larger one while its trees reach new places. So the cells lose at most that part
// by it. True if the query is answered, or stopped.
bool Search::try_trees() {
  if (first_try_ == nullptr) return false;
  const std::uint64_t since = cells_work() - work_before_;
  const std::uint64_t turn =
      since / (first_try_->promising() ? kGrowingTreesShare : kStuckTreesShare);
  if (turn < kLeastTurn) return false;
  work_before_ += since;
  std::vector<Configuration> path = first_try_->go_on(turn, [this] { return stop(); });
  if (path.empty()) return query_.stopped_by.has_value();
  conclude_path(std::move(path), DecidedBy::kFirstTry);
  return true;
}

// A path along the ridge of the clearance through a channel that is still MIXED. True if the query
// is answered, or stopped.
bool Search::try_ridge(const std::vector<CellId>& channel) {
  if (!ridge_.due() || !pick_goal(channel.back())) return false;
  const Stopwatch watch(query_.clock, statistics_.seconds.path);
  std::vector<Configuration> path =
      ridge_.attempt(channel, query_.start, query_.goal, [this] { return stop(); });
  if (path.empty()) return query_.stopped_by.has_value();
  conclude_path(std::move(path), DecidedBy::kRidge);
  return true;
}

// Late in a search only the cells are split where a channel is stuck, or the path is found that
// leads through all of it. False if neither came about.
bool Search::split_stuck(const std::vector<CellId>& channel) {
  const std::uint64_t before = statistics_.axis_work();
  const bool due = statistics_.labelled_cells >= kSurveyFrom &&
                   survey_work_ <= kSurveyShare * (before - survey_work_);
  if (!due || !problem_.ablation.survey) return false;
  if (goals_ && !pick_goal(channel.back())) return false;
  Survey survey;
  {
    const Stopwatch watch(query_.clock, statistics_.seconds.path);
    const Terminator terminator = [this] { return stop(); };
    survey = survey_.look(channel, query_.start, query_.goal, terminator);
    survey_work_ += statistics_.axis_work() - before;
    if (!survey.path.empty()) {
      CollisionHint hint(problem_, tree_);
      if (certify_shortened(problem_, tree_, segments_, hint, survey.path, terminator))
        return false;
      conclude_path(std::move(survey.path), DecidedBy::kRidge);
      return true;
    }
  }
  if (split_mixed(survey.stuck)) return true;
  if (survey.apart.empty()) return false;
  for (const auto& [a, b] : survey.apart) join_solid(a, b);
  return true;
}

// Two solid neighbours along whose face a channel goes on, or does not.
void Search::join_solid(const CellId a, const CellId b) {
  if (!subdivision_.linked(a, b)) return;  // one of them has been split by now
  const Link link = test_face(a, b);
  const Terminator terminator = [this] { return stop(); };
  if (link.state == LinkState::kOpen) {
    if (survey_.join_by(a, b, link.connector, terminator)) return;
  } else if (link.state == LinkState::kBlocked) {
    subdivision_.disconnect(a, b);
    channels_.on_disconnected(a, b);
    return;
  }
  resolve_doubt(a, b);
}

void Search::conclude_path(std::vector<Configuration> path, const DecidedBy by) {
  query_.answer.path = report_path(std::move(path));
  query_.decide(Verdict::kPath, by);
}

bool Search::stop() {
  if (query_.stopped_by) return true;
  statistics_.constraint_bytes = subdivision_.constraint_bytes();
  statistics_.memory_bytes = subdivision_.bytes() + channels_.bytes() + survey_.bytes() +
                             (first_try_ == nullptr ? 0 : first_try_->bytes());
  query_.stopped_by =
      query_.check({subdivision_.size(), statistics_.memory_bytes}, [this] { return progress(); });
  if (query_.stopped_by) query_.leave_undecided(*query_.stopped_by);
  return query_.stopped_by.has_value();
}

Progress Search::progress() const {
  const std::array<Count, 4> n = take_census(subdivision_).by_label.of;
  Progress out;
  out.cells = subdivision_.size();
  out.free = n[static_cast<std::size_t>(Label::kFree)];
  out.star = n[static_cast<std::size_t>(Label::kStar)];
  out.full = n[static_cast<std::size_t>(Label::kFull)];
  out.mixed = n[static_cast<std::size_t>(Label::kMixed)];
  out.channel_length = statistics_.channel_length;
  out.rounds = statistics_.search_rounds;
  return out;
}

}  // namespace planner
