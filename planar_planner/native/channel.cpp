#include "channel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace planner {

namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

double tune(const char* name, double value) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : value;
}
const double kSlack = tune("T_SLACK", 0.3);
const double kDown = tune("T_DOWN", 0.3);
const double kSolid = tune("T_SOLID", 0.02);
const double kPos0 = tune("T_POS0", 1.0), kPos1 = tune("T_POS1", 0.0), kNeg0 = tune("T_NEG0", 1.0), kNeg1 = tune("T_NEG1", 3.0);
const double kSize = tune("T_SIZE", 1.0);

// More than any channel without exhausted cells can cost.
constexpr double kBarrier = 1e15;

std::uint64_t edge_key(const CellId a, const CellId b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

}  // namespace

double crossing_cost(const Cell& cell) {
  const double size = std::pow(static_cast<double>(cell.size), kSize);
  if (cell.solid()) return kSolid * size;
  const double r = static_cast<double>(cell.separation);
  return size * (r > 0 ? kPos0 / (1 + kPos1 * r) : kNeg0 - kNeg1 * r);
}

double ChannelSearch::step_cost(const CellId from, const CellId to) const {
  const double cost = nodes_[to].cost;
  if (doubtful_.empty() || !doubtful_.contains(edge_key(from, to))) return cost;
  return cost + kBarrier;
}

std::size_t ChannelSearch::bytes() const {
  return nodes_.capacity() * sizeof(Node) + (open_.size() + orphans_.size()) * sizeof(Step) +
         doubtful_.size() * 4 * sizeof(std::uint64_t);
}

void ChannelSearch::reset(const CellId start, const CellId goal) {
  start_ = start;
  goal_ = goal;
  nodes_.clear();
  add_nodes();
  open_ = {};
  orphans_ = {};
  raised_ = {start};
}

void ChannelSearch::orphan(const CellId cell) {
  Node& node = nodes_[cell];
  if (node.distance == kUnreached) return;
  orphans_.push({node.distance, cell, kNoCell});
  node.distance = node.queued = kUnreached;
  node.predecessor = kNoCell;
}

void ChannelSearch::orphan_successors(const CellId cell) {
  for (const CellId next : subdivision_.cell(cell).neighbours)
    if (nodes_[next].predecessor == cell) orphan(next);
}

void ChannelSearch::before_split(const CellId cell) {
  orphan_successors(cell);
  parent_reached_ = nodes_[cell].distance < kUnreached;
  nodes_[cell] = Node{};
}

void ChannelSearch::after_split(const CellId cell, const CellId start, const CellId goal) {
  add_nodes();
  start_ = start;
  goal_ = goal;
  const CellId first = subdivision_.cell(cell).children;
  CellId nearer = cheapest_step(first).key <= cheapest_step(first + 1).key ? first : first + 1;
  if (start_ == first || start_ == first + 1) nearer = start_;
  if (!parent_reached_) {
    raised_.insert(raised_.end(), {first, first + 1});
    return;
  }
  // At once, so that the parent's successors can stay where they are; the sibling may follow.
  for (const CellId child : {nearer, 2 * first + 1 - nearer}) {
    const Step step = cheapest_step(child);
    if (step.key == kUnreached) continue;
    nodes_[child].distance = nodes_[child].queued = step.key;
    nodes_[child].predecessor = step.from;
  }
}

void ChannelSearch::add_nodes() {
  for (auto id = static_cast<CellId>(nodes_.size()); id < subdivision_.size(); ++id) {
    const Cell& cell = subdivision_.cell(id);
    Node node;
    node.cost = cell.exhausted ? kBarrier : static_cast<double>(cell.cost);
    node.live = cell.leaf() && cell.label != Label::kFull;
    nodes_.push_back(node);
  }
}

void ChannelSearch::on_exhausted(const CellId cell) {
  nodes_[cell].cost = kBarrier;
  orphan(cell);
}

void ChannelSearch::on_disconnected(const CellId a, const CellId b) {
  if (nodes_[a].predecessor == b) orphan(a);
  if (nodes_[b].predecessor == a) orphan(b);
}

void ChannelSearch::on_doubtful(const CellId a, const CellId b) {
  doubtful_[edge_key(a, b)] = true;
  on_disconnected(a, b);
}

// A reached neighbour that is nearer than the orphan was cannot hang below it.
bool ChannelSearch::adopt(const CellId cell, const double old_distance) {
  double best = kUnreached;
  CellId from = kNoCell;
  for (const CellId next : subdivision_.cell(cell).neighbours) {
    if (nodes_[next].distance >= old_distance) continue;
    const double cost = step_cost(next, cell);
    if (nodes_[next].distance + (1.0 - kSlack) * cost > old_distance) continue;
    if (nodes_[next].distance + cost < best) {
      best = nodes_[next].distance + cost;
      from = next;
    }
  }
  if (from == kNoCell) return false;
  nodes_[cell].distance = nodes_[cell].queued = std::min(old_distance, best);
  nodes_[cell].predecessor = from;
  return true;
}

void ChannelSearch::mend() {
  while (!orphans_.empty()) {
    const Step lost = orphans_.top();
    orphans_.pop();
    if (nodes_[lost.cell].distance != kUnreached || !nodes_[lost.cell].live) continue;
    ++statistics_.search_expansions;
    if (lost.cell != start_ && adopt(lost.cell, lost.key)) continue;
    orphan_successors(lost.cell);
    raised_.push_back(lost.cell);
  }
  for (const CellId cell : raised_) offer(cell);
  raised_.clear();
}

// The cheapest way into a leaf from a reached neighbour; key kUnreached if there is none.
ChannelSearch::Step ChannelSearch::cheapest_step(const CellId cell) const {
  Step best{kUnreached, cell, kNoCell};
  if (!nodes_[cell].live) return best;
  if (cell == start_) return {0.0, cell, kNoCell};
  for (const CellId next : subdivision_.cell(cell).neighbours) {
    if (nodes_[next].distance == kUnreached) continue;
    const double key = nodes_[next].distance + step_cost(next, cell);
    if (key < best.key) best = {key, cell, next};
  }
  return best;
}

// Queues an unreached leaf behind its cheapest reached neighbour.
void ChannelSearch::offer(const CellId cell) {
  const Step step = cheapest_step(cell);
  nodes_[cell].queued = step.key;
  if (step.key < kUnreached) open_.push(step);
}

void ChannelSearch::settle(const Step& step) {
  ++statistics_.search_expansions;
  nodes_[step.cell].distance = step.key;
  nodes_[step.cell].predecessor = step.from;
  for (const CellId next : subdivision_.cell(step.cell).neighbours) {
    Node& node = nodes_[next];
    const double cost = step_cost(step.cell, next);
    const double key = step.key + cost;
    const bool better = node.distance == kUnreached || key < node.distance - kDown * cost;
    if (!better || key >= node.queued) continue;
    node.queued = key;
    open_.push({key, next, step.cell});
  }
}

bool ChannelSearch::find(std::vector<CellId>& channel) {
  mend();
  while (!open_.empty() && open_.top().key < nodes_[goal_].distance) {
    const Step step = open_.top();
    open_.pop();
    const Node& node = nodes_[step.cell];
    if (!node.live || step.key != node.queued || step.key >= node.distance) continue;
    if (step.from != kNoCell) {
      const Node& from = nodes_[step.from];
      const bool stale = !from.live || from.distance == kUnreached ||
                         from.distance + step_cost(step.from, step.cell) > step.key;
      if (stale) {
        if (node.distance == kUnreached)
          offer(step.cell);
        else
          nodes_[step.cell].queued = node.distance;
        continue;
      }
    }
    settle(step);
  }
  channel.clear();
  if (nodes_[goal_].distance == kUnreached) return false;
  for (CellId cell = goal_; cell != kNoCell; cell = nodes_[cell].predecessor)
    channel.push_back(cell);
  std::reverse(channel.begin(), channel.end());
  return true;
}

bool ChannelSearch::passes_barrier(const std::vector<CellId>& channel) const {
  for (std::size_t i = 0; i < channel.size(); ++i) {
    if (subdivision_.cell(channel[i]).exhausted) return true;
    if (i > 0 && doubtful_.contains(edge_key(channel[i - 1], channel[i]))) return true;
  }
  return false;
}

}  // namespace planner
