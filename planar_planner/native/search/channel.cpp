#include "channel.hpp"

#include <algorithm>
#include <cmath>

#include "tuning.hpp"

namespace planner {

double crossing_cost(const CellFacts& cell) {
  const double size =
      std::pow(cell.relative_size, cell.relative_size < 1.0 ? kSmallExponent : kLargeExponent);
  if (cell.label != Label::kMixed) return kSolidCost * size;
  const double depth =
      cell.separation > 0.0 ? kFreeCentreCost : kMixedCost - kDepthCost * cell.separation;
  return size * depth * (1.0 + kThinnessCost * cell.thinness);
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
    if (from_start_.mend_way_to(meeting.cell) && from_goal_.mend_way_to(meeting.cell) &&
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
