#include "channel.hpp"

#include <algorithm>
#include <cmath>

namespace planner {

namespace {

// Crossing costs, by size = motion radius / robot reach. They steer the search and prove nothing.
// The values were found by random search over mazes, fields, gears, gates and smaller scenes,
// scored by labelled cells and expansions; two of them also decide whether a search ends:
// - A strip of n = L / size MIXED cells along a contact costs L size^(p - 1). With p < 1 for small
//   cells that grows while the strip is refined, so that it cannot outbid every other channel for
//   ever.
// - A cell that has been halved along one axis again and again without being decided will take more
//   halving yet: its cost grows with its thinness.
constexpr double kLargeExponent = 1.25;  // of sizes above 1: prefers what is already resolved
constexpr double kSmallExponent = 0.5;   // of sizes below 1
constexpr double kThinnessCost = 0.25;   // more for every halving of one axis beyond the others
constexpr double kSolidCost = 0.005;     // FREE or STAR
constexpr double kFreeCentreCost = 0.5;  // MIXED, free at the centre by the labelling's hint
constexpr double kMixedCost = 1.0;       // MIXED, in contact at the centre ...
constexpr double kDepthCost = 3.0;       // ... and more for every motion radius that it is in deep

}  // namespace

double crossing_cost(const Label label, const double relative_size, const double separation,
                     const double thinness) {
  const double size =
      std::pow(relative_size, relative_size < 1.0 ? kSmallExponent : kLargeExponent);
  if (label != Label::kMixed) return kSolidCost * size;
  const double depth = separation > 0.0 ? kFreeCentreCost : kMixedCost - kDepthCost * separation;
  return size * depth * (1.0 + kThinnessCost * thinness);
}

std::size_t ChannelSearch::bytes() const {
  return from_start_.bytes() + from_goal_.bytes() + meetings_.bytes() +
         doubtful_.size() * 4 * sizeof(std::uint64_t);
}

void ChannelSearch::reset(const CellId start, const CellId goal) {
  doubtful_.clear();
  from_start_.reset(start);
  from_goal_.reset(goal);
  meetings_ = {};
}

void ChannelSearch::reset(const CellId start, const Roots& goals) {
  doubtful_.clear();
  from_start_.reset(start);
  from_goal_.reset(goals);
  meetings_ = {};
}

void ChannelSearch::rebuild() {
  from_start_.rebuild();
  from_goal_.rebuild();
  meetings_ = {};
}

void ChannelSearch::before_split(const CellId cell) {
  if (!doubtful_.empty())
    for (const CellId next : subdivision_.cell(cell).neighbours)
      doubtful_.erase(link_key(cell, next));
  from_start_.before_split(cell);
  from_goal_.before_split(cell);
}

void ChannelSearch::after_split(const CellId lower, const CellId upper, const CellId start,
                                const CellId goal) {
  from_start_.after_split(lower, upper, start);
  from_goal_.after_split(lower, upper, goal);
}

void ChannelSearch::on_exhausted(const CellId cell) {
  from_start_.on_exhausted(cell);
  from_goal_.on_exhausted(cell);
}

void ChannelSearch::on_disconnected(const CellId a, const CellId b) {
  from_start_.on_link_lost(a, b);
  from_goal_.on_link_lost(a, b);
}

void ChannelSearch::on_doubtful(const CellId a, const CellId b) {
  doubtful_.insert(link_key(a, b));
  on_disconnected(a, b);
}

float ChannelSearch::cost_through(const CellId cell) const {
  // Both distances count the cell itself; a root's counts nothing.
  return from_start_.distance(cell) + from_goal_.distance(cell) - from_start_.cost(cell);
}

void ChannelSearch::note_meetings() {
  for (DistanceTree* tree : {&from_start_, &from_goal_}) {
    for (const CellId cell : tree->changed())
      if (from_start_.reached(cell) && from_goal_.reached(cell))
        meetings_.push({cost_through(cell), cell});
    tree->changed().clear();
  }
  meetings_.sweep([&](const Meeting& meeting) {
    return from_start_.reached(meeting.cell) && from_goal_.reached(meeting.cell) &&
           cost_through(meeting.cell) == meeting.cost;
  });
}

ChannelSearch::Meeting ChannelSearch::best_meeting() {
  note_meetings();
  while (!meetings_.empty()) {
    const Meeting top = meetings_.top();
    const bool holds = from_start_.reached(top.cell) && from_goal_.reached(top.cell);
    const float cost = holds ? cost_through(top.cell) : kUnreached;
    if (cost == top.cost) return top;
    meetings_.pop();
    if (cost < kUnreached && cost > top.cost) meetings_.push({cost, top.cell});
  }
  return {kUnreached, kNoCell};
}

bool ChannelSearch::find(std::vector<CellId>& channel) {
  from_start_.begin_round();
  from_goal_.begin_round();
  Meeting meeting{kUnreached, kNoCell};
  for (;;) {
    const float start_key = from_start_.next_key();
    const float goal_key = from_goal_.next_key();
    meeting = best_meeting();  // after the keys: mending for them makes and undoes meetings
    if (start_key + goal_key < meeting.cost) {
      (start_key <= goal_key ? from_start_ : from_goal_).settle_next();
      continue;
    }
    if (meeting.cell == kNoCell) break;
    if (from_start_.sound(meeting.cell) && from_goal_.sound(meeting.cell) &&
        cost_through(meeting.cell) == meeting.cost)
      break;
  }
  channel.clear();
  if (meeting.cell == kNoCell) return false;
  for (CellId cell = meeting.cell; cell != kNoCell; cell = from_start_.predecessor(cell))
    channel.push_back(cell);
  std::reverse(channel.begin(), channel.end());
  for (CellId cell = from_goal_.predecessor(meeting.cell); cell != kNoCell;
       cell = from_goal_.predecessor(cell))
    channel.push_back(cell);
  return true;
}

bool ChannelSearch::passes_barrier(const std::vector<CellId>& channel) const {
  for (std::size_t i = 0; i < channel.size(); ++i) {
    if (subdivision_.cell(channel[i]).exhausted) return true;
    if (i > 0 && doubtful_.contains(link_key(channel[i - 1], channel[i]))) return true;
  }
  return false;
}

}  // namespace planner
