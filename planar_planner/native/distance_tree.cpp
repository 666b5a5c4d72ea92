#include "distance_tree.hpp"

#include <algorithm>
#include <cstdlib>

namespace planner {

namespace {

double tune(const char* name, double value) {
  const char* s = std::getenv(name);
  return s ? std::atof(s) : value;
}
const double kSlackDown = tune("T_SLACK", 0.3);
const double kSlackUp = tune("T_DOWN", 0.3);

// More than any channel without exhausted cells and doubtful links can cost.
constexpr double kBarrier = 1e15;

}  // namespace

std::size_t DistanceTree::bytes() const {
  return nodes_.capacity() * sizeof(Node) + (open_.size() + orphans_.size()) * sizeof(Step);
}

void DistanceTree::reset(const CellId root) {
  root_ = root;
  nodes_.clear();
  add_nodes();
  open_ = {};
  orphans_ = {};
  changed_.clear();
  raised_ = {root};
}

void DistanceTree::add_nodes() {
  for (auto id = static_cast<CellId>(nodes_.size()); id < subdivision_.size(); ++id) {
    const Cell& cell = subdivision_.cell(id);
    Node node;
    node.cost = cell.exhausted ? kBarrier : static_cast<double>(cell.cost);
    node.live = cell.leaf() && cell.label != Label::kFull;
    nodes_.push_back(node);
  }
}

double DistanceTree::step_cost(const CellId from, const CellId to) const {
  const double cost = nodes_[to].cost;
  if (doubtful_.empty() || !doubtful_.contains(link_key(from, to))) return cost;
  return cost + kBarrier;
}

void DistanceTree::place(const CellId cell, const double distance, const CellId predecessor) {
  Node& node = nodes_[cell];
  node.distance = node.queued = distance;
  node.predecessor = predecessor;
  changed_.push_back(cell);
}

void DistanceTree::orphan(const CellId cell) {
  Node& node = nodes_[cell];
  if (node.distance == kUnreached) return;
  orphans_.push({node.distance, cell, kNoCell});
  node.distance = node.queued = kUnreached;
  node.predecessor = kNoCell;
}

void DistanceTree::orphan_successors(const CellId cell) {
  for (const CellId next : subdivision_.cell(cell).neighbours)
    if (nodes_[next].predecessor == cell) orphan(next);
}

void DistanceTree::before_split(const CellId cell) {
  orphan_successors(cell);
  parent_reached_ = nodes_[cell].distance < kUnreached;
  nodes_[cell] = Node{};
}

void DistanceTree::after_split(const CellId cell, const CellId root) {
  add_nodes();
  root_ = root;
  const CellId first = subdivision_.cell(cell).children;
  if (!parent_reached_) {
    raised_.insert(raised_.end(), {first, first + 1});
    return;
  }
  // At once, so that the parent's successors can stay where they are; the sibling may follow.
  CellId nearer = cheapest_step(first).key <= cheapest_step(first + 1).key ? first : first + 1;
  if (root_ == first || root_ == first + 1) nearer = root_;
  for (const CellId child : {nearer, 2 * first + 1 - nearer}) {
    const Step step = cheapest_step(child);
    if (step.key < kUnreached) place(child, step.key, step.from);
  }
}

void DistanceTree::on_exhausted(const CellId cell) {
  nodes_[cell].cost = kBarrier;
  orphan(cell);
}

void DistanceTree::on_link_lost(const CellId a, const CellId b) {
  if (nodes_[a].predecessor == b) orphan(a);
  if (nodes_[b].predecessor == a) orphan(b);
}

// A reached neighbour that is nearer than the orphan was cannot hang below it.
bool DistanceTree::adopt(const CellId cell, const double old_distance) {
  double best = kUnreached;
  CellId from = kNoCell;
  for (const CellId next : subdivision_.cell(cell).neighbours) {
    if (nodes_[next].distance >= old_distance) continue;
    const double cost = step_cost(next, cell);
    if (nodes_[next].distance + (1.0 - kSlackDown) * cost > old_distance) continue;
    if (nodes_[next].distance + cost < best) {
      best = nodes_[next].distance + cost;
      from = next;
    }
  }
  if (from == kNoCell) return false;
  place(cell, std::min(old_distance, best), from);
  return true;
}

void DistanceTree::mend() {
  while (!orphans_.empty()) {
    const Step lost = orphans_.top();
    orphans_.pop();
    if (nodes_[lost.cell].distance != kUnreached || !nodes_[lost.cell].live) continue;
    ++statistics_.search_expansions;
    if (lost.cell != root_ && adopt(lost.cell, lost.key)) continue;
    orphan_successors(lost.cell);
    raised_.push_back(lost.cell);
  }
  for (const CellId cell : raised_) offer(cell);
  raised_.clear();
  // The root is reached before anything is asked: a tree that cannot grow is then a component.
  if (!reached(root_)) settle({0.0, root_, kNoCell});
}

// The cheapest way into a leaf from a reached neighbour; key kUnreached if there is none.
DistanceTree::Step DistanceTree::cheapest_step(const CellId cell) const {
  Step best{kUnreached, cell, kNoCell};
  if (!nodes_[cell].live) return best;
  if (cell == root_) return {0.0, cell, kNoCell};
  for (const CellId next : subdivision_.cell(cell).neighbours) {
    if (nodes_[next].distance == kUnreached) continue;
    const double key = nodes_[next].distance + step_cost(next, cell);
    if (key < best.key) best = {key, cell, next};
  }
  return best;
}

// Queues an unreached leaf behind its cheapest reached neighbour.
void DistanceTree::offer(const CellId cell) {
  if (nodes_[cell].distance < kUnreached) return;
  const Step step = cheapest_step(cell);
  nodes_[cell].queued = step.key;
  if (step.key < kUnreached) open_.push(step);
}

double DistanceTree::next_key() {
  while (!open_.empty()) {
    const Step step = open_.top();
    const Node& node = nodes_[step.cell];
    if (node.live && step.key == node.queued && step.key < node.distance) {
      if (step.from == kNoCell) return step.key;
      const Node& from = nodes_[step.from];
      if (from.live && from.distance < kUnreached &&
          from.distance + step_cost(step.from, step.cell) <= step.key)
        return step.key;
      open_.pop();
      if (node.distance == kUnreached)
        offer(step.cell);
      else
        nodes_[step.cell].queued = node.distance;
      continue;
    }
    open_.pop();
  }
  return kUnreached;
}

void DistanceTree::settle_next() {
  const Step step = open_.top();
  open_.pop();
  settle(step);
}

void DistanceTree::settle(const Step& step) {
  ++statistics_.search_expansions;
  place(step.cell, step.key, step.from);
  for (const CellId next : subdivision_.cell(step.cell).neighbours) {
    Node& node = nodes_[next];
    const double cost = step_cost(step.cell, next);
    const double key = step.key + cost;
    const bool better = node.distance == kUnreached || key < node.distance - kSlackUp * cost;
    if (!better || key >= node.queued) continue;
    node.queued = key;
    open_.push({key, next, step.cell});
  }
}

}  // namespace planner
