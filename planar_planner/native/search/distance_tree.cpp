#include "distance_tree.hpp"

#include <algorithm>

#include "tuning.hpp"

namespace planner {

std::size_t DistanceTree::bytes() const {
  return nodes_.capacity() * sizeof(Node) + open_.bytes() + orphans_.bytes();
}

void DistanceTree::reset(const CellId root) {
  root_ = root;
  roots_ = nullptr;
  rebuild();
}

void DistanceTree::reset(const Roots& roots) {
  root_ = kNoCell;
  roots_ = &roots;
  rebuild();
}

void DistanceTree::rebuild() {
  nodes_.resize(subdivision_.size());
  for (CellId id = 0; id < nodes_.size(); ++id) refresh(id);
  open_ = {};
  orphans_ = {};
  changed_.clear();
  raised_.clear();
  if (roots_ == nullptr) raised_.push_back(root_);
  if (roots_ == nullptr) return;
  for (CellId id = 0; id < nodes_.size(); ++id)
    if ((*roots_)[id]) raised_.push_back(id);
}

void DistanceTree::refresh(const CellId cell) {
  const Cell& c = subdivision_.cell(cell);
  nodes_[cell] = Node{};
  nodes_[cell].cost = c.exhausted ? kBarrier : c.cost;
  if (c.label == Label::kFull) nodes_[cell].cost = -1.0F;
}

float DistanceTree::step_cost(const CellId from, const CellId to) const {
  if (doubtful_.empty() || !doubtful_.contains(link_key(from, to))) return cost(to);
  return cost(to) + kBarrier;
}

void DistanceTree::place(const CellId cell, const float distance, const CellId predecessor) {
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

void DistanceTree::after_split(const CellId lower, const CellId upper, const CellId root) {
  root_ = root;
  grow(nodes_);
  nodes_.resize(subdivision_.size());
  refresh(lower);
  refresh(upper);
  if (!parent_reached_) {
    raised_.insert(raised_.end(), {lower, upper});
    return;
  }
  // At once, so that the parent's successors can stay where they are; the sibling may follow.
  bool lower_first = cheapest_step(lower).key <= cheapest_step(upper).key;
  if (roots_ == nullptr && (root == lower || root == upper)) lower_first = root == lower;
  for (const CellId half : {lower_first ? lower : upper, lower_first ? upper : lower}) {
    const Step step = cheapest_step(half);
    if (step.key < kUnreached)
      place(half, step.key, step.from);
    else
      raised_.push_back(half);  // its neighbours may be orphans that are adopted later
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

void DistanceTree::on_root_lost(const CellId cell) {
  orphan(cell);
}

// A reached neighbour that is nearer than the orphan was cannot hang below it.
bool DistanceTree::adopt(const CellId cell, const float old_distance) {
  float best = kUnreached;
  CellId from = kNoCell;
  for (const CellId next : subdivision_.cell(cell).neighbours) {
    if (nodes_[next].distance >= old_distance) continue;
    const float cost = step_cost(next, cell);
    if (nodes_[next].distance + (1.0F - kSlackDown) * cost > old_distance) continue;
    if (nodes_[next].distance + cost < best) {
      best = nodes_[next].distance + cost;
      from = next;
    }
  }
  if (from == kNoCell) return false;
  place(cell, std::min(old_distance, best), from);
  return true;
}

// One of several roots that is not reached: at once, whatever its cost.
bool DistanceTree::settle_root(const CellId cell) {
  if (roots_ == nullptr || !is_root(cell) || reached(cell) || nodes_[cell].cost < 0.0F)
    return false;
  settle(cheapest_step(cell));
  return true;
}

void DistanceTree::begin_round() {
  for (const CellId cell : raised_)
    if (!settle_root(cell)) offer(cell);
  raised_.clear();
  open_.sweep([&](const Step& step) {
    const Node& node = nodes_[step.cell];
    return step.key == node.queued && step.key < node.distance;
  });
  // Roots are reached before anything is asked: a tree that cannot grow is then a component, or all
  // components of several roots.
  if (roots_ == nullptr && !reached(root_)) settle({0.0F, root_, kNoCell});
}

// Hangs the nearest orphan below another neighbour, or gives it and then its branch up.
void DistanceTree::mend_next() {
  const Step lost = orphans_.top();
  orphans_.pop();
  if (reached(lost.cell) || nodes_[lost.cell].cost < 0.0F) return;
  ++statistics_.search_expansions;
  if (!is_root(lost.cell) && adopt(lost.cell, lost.key)) {
    // Unreached neighbours may have been looked at while this one was lost.
    for (const CellId next : subdivision_.cell(lost.cell).neighbours)
      if (!reached(next)) tell(next, lost.cell);
    return;
  }
  orphan_successors(lost.cell);
  if (!settle_root(lost.cell)) offer(lost.cell);
}

bool DistanceTree::mend_way_to(const CellId cell) {
  while (reached(cell) && !orphans_.empty() && orphans_.top().key <= distance(cell)) mend_next();
  return reached(cell);
}

// Offers a way into `next` by a neighbour, if it is better than what is queued.
void DistanceTree::tell(const CellId next, const CellId by) {
  const float key = nodes_[by].distance + step_cost(by, next);
  if (key >= nodes_[next].queued) return;
  nodes_[next].queued = key;
  open_.push({key, next, by});
}

// The cheapest way into a leaf from a reached neighbour; key kUnreached if there is none.
DistanceTree::Step DistanceTree::cheapest_step(const CellId cell) const {
  Step best{kUnreached, cell, kNoCell};
  if (nodes_[cell].cost < 0.0F) return best;
  if (is_root(cell)) return {roots_ == nullptr ? 0.0F : nodes_[cell].cost, cell, kNoCell};
  for (const CellId next : subdivision_.cell(cell).neighbours) {
    if (nodes_[next].distance == kUnreached) continue;
    const float key = nodes_[next].distance + step_cost(next, cell);
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

// Is the step's way in still as good as its key says? Ids are used again, so adjacency is checked.
bool DistanceTree::holds(const Step& step) const {
  if (step.from == kNoCell) return is_root(step.cell);
  return subdivision_.linked(step.cell, step.from) &&
         nodes_[step.from].distance + step_cost(step.from, step.cell) <= step.key;
}

float DistanceTree::next_key() {
  for (;;) {
    const float lost = orphans_.empty() ? kUnreached : orphans_.top().key;
    if (open_.empty() && orphans_.empty()) return kUnreached;
    if (open_.empty() || lost <= open_.top().key) {
      mend_next();
      continue;
    }
    const Step step = open_.top();
    Node& node = nodes_[step.cell];
    const bool wanted = step.key == node.queued && step.key < node.distance && node.cost >= 0.0F;
    if (wanted && holds(step)) return step.key;
    open_.pop();
    if (!wanted) continue;
    if (reached(step.cell))
      node.queued = node.distance;
    else
      offer(step.cell);
  }
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
    const Node& node = nodes_[next];
    const float cost = step_cost(step.cell, next);
    const float key = step.key + cost;
    if (!reached(next) || key < node.distance - kSlackUp * cost) tell(next, step.cell);
  }
}

}  // namespace planner
