#include "subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "growth.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

// Searches from the back, because a cell that is split is mostly one that was added last, also in
// the long lists of large cells.
CellId* find_last(std::vector<CellId>& list, const CellId value) {
  for (std::size_t i = list.size(); i-- > 0;)
    if (list[i] == value) return &list[i];
  return nullptr;
}

void erase_value(std::vector<CellId>& list, const CellId value) {
  CellId* const at = find_last(list, value);
  if (at == nullptr) return;
  *at = list.back();
  list.pop_back();
}

// How often the cell has been halved along single axes beyond its motion radius: the sum of
// log2(radius / width).
double thinness(const std::array<double, 3>& widths, const double radius) {
  double sum = 0.0;
  for (const double width : widths)
    if (width > 0.0) sum += std::log2(radius / width);
  return sum;
}

// The sway along those axes only, if there are any, along which halving settles the cell.
pdg::Sway settling_sway(const CellBox& box, const Classification& found) {
  const std::array<double, 3> sways{found.sway.g1, found.sway.g2, found.sway.turn};
  std::array<double, 3> out{};
  bool any = false;
  for (Axis k = 0; k < kNoAxis; ++k) {
    const bool settles = box.level[k] < kMaxLevel && found.settles[k];
    out[k] = settles ? sways[k] : -1.0;
    any = any || settles;
  }
  return any ? pdg::Sway{out[0], out[1], out[2]} : found.sway;
}

struct Touched {
  bool lower, upper;
};

// Which halves of a box split along `axis` share a face with a neighbour of the whole? The other
// axes have not changed.
Touched touched_halves(const Halves& halves, const CellBox& neighbour, const Axis axis) {
  const std::uint64_t low = halves.lower.low[axis];
  const std::uint64_t middle = halves.upper.low[axis];
  const std::uint64_t high = halves.upper.high(axis);
  const std::uint64_t begin = neighbour.low[axis];
  const std::uint64_t end = neighbour.high(axis);
  if (begin < high && low < end) return {.lower = begin<middle, .upper = end> middle};
  // The face is an end of the split axis; theta wraps.
  const bool at_low = end == low || (axis == kTheta && low == 0 && end == kUnit);
  return {.lower = at_low, .upper = !at_low};
}

}  // namespace

Subdivision::Subdivision(const CellSpace& space, Labeller& labeller, Statistics& statistics,
                         const CellCost cost)
    : space_(space),
      labeller_(labeller),
      statistics_(statistics),
      cost_(cost),
      posed_(labeller.robot()) {
  ConstraintList root;
  labeller_.root_list(root);
  for (std::uint64_t i = 0; i < (std::uint64_t{1} << root_level()); ++i) {
    cells_.push_back(make_cell(root_box(i), view(root)));
    cells_.back().branch = kRoot | static_cast<std::uint32_t>(i);
    roots_.push_back(kLeaf | static_cast<std::uint32_t>(i));
  }
  for (CellId a = 0; a < cells_.size(); ++a)
    for (CellId b = 0; b < a; ++b) {
      Axis axis = kNoAxis;
      if (cells_[a].label != Label::kFull && cells_[b].label != Label::kFull &&
          adjacent(cells_[a].box, cells_[b].box, axis))
        link(a, b);
    }
}

// Quarter turns at most: two cells then share at most one face, and half-angles stay below pi/2.
std::uint8_t Subdivision::root_level() const {
  return space_.rotation ? 2 : 0;
}

CellBox Subdivision::root_box(const std::size_t part) const {
  CellBox box;
  box.level[kTheta] = root_level();
  box.low[kTheta] = part * box.size(kTheta);
  return box;
}

std::uint64_t Subdivision::guard_turns(const CellId id) const {
  const CellBox& box = cells_[id].box;
  return box.low[kTheta] + (space_.rotation ? box.size(kTheta) / 2 : 0);
}

std::size_t Subdivision::bytes() const {
  return cells_.capacity() * sizeof(Cell) + branches_.capacity() * sizeof(Branch) +
         guards_.capacity() * sizeof(Vec2) + proof_bytes_ + store_.bytes() + neighbour_bytes_;
}

FullClaim Subdivision::claim(const CellId id) const {
  const Cell& cell = cells_[id];
  FullClaim claim;
  claim.box = extent_of(cell.box);
  claim.joint = cell.joint;
  if (cell.joint)
    claim.proof = proofs_[cell.proof];
  else
    claim.witness = cell.witness;
  return claim;
}

CellId Subdivision::locate(const std::array<std::uint64_t, 3>& point) const {
  const std::uint64_t root = point[kTheta] >> (kCoordinateBits - root_level());
  CellBox box = root_box(root);
  std::uint32_t at = roots_[root];
  while ((at & kLeaf) == 0) {
    const Branch& branch = branches_[at];
    const Halves halves = halve(box, branch.axis);
    const bool upper = point[branch.axis] >= halves.upper.low[branch.axis];
    box = upper ? halves.upper : halves.lower;
    at = upper ? branch.upper : branch.lower;
  }
  return at & ~kLeaf;
}

std::vector<CellId> Subdivision::leaves_near(const std::array<std::uint64_t, 3>& point,
                                             const std::uint64_t slack) const {
  std::vector<CellId> out;
  for (std::size_t i = 0; i < roots_.size(); ++i)
    collect_near(roots_[i], root_box(i), point, slack, out);
  return out;
}

void Subdivision::collect_near(const std::uint32_t node, const CellBox& box,
                               const std::array<std::uint64_t, 3>& point, const std::uint64_t slack,
                               std::vector<CellId>& out) const {
  for (Axis k = 0; k < kNoAxis; ++k) {
    const std::uint64_t p = point[k];
    bool near = box.low[k] <= p + slack && p <= box.high(k) + slack;
    if (k == kTheta)  // turn 0 is turn 1
      near =
          near || (box.low[k] == 0 && kUnit <= p + slack) || (box.high(k) == kUnit && p <= slack);
    if (!near) return;
  }
  if ((node & kLeaf) != 0) return out.push_back(node & ~kLeaf);
  const Branch& branch = branches_[node];
  const Halves halves = halve(box, branch.axis);
  collect_near(branch.lower, halves.lower, point, slack, out);
  collect_near(branch.upper, halves.upper, point, slack, out);
}

// The axis along which the motion is widest, among those that sway the undecided functions about as
// much as any. In a corridor the axis along it does not, and is not halved: that keeps cells few
// where the way is long and narrow.
Axis Subdivision::best_axis(const CellBox& box, const pdg::Sway& sway,
                            const std::array<double, 3>& widths) const {
  const std::array<double, 3> sways{sway.g1, sway.g2, sway.turn};
  const std::size_t axes = space_.rotation ? 3 : 2;
  double most = 0.0;
  for (Axis k = 0; k < axes; ++k)
    if (box.level[k] < kMaxLevel) most = std::max(most, sways[k]);
  Axis best = kNoAxis;
  for (Axis k = 0; k < axes; ++k)
    if (box.level[k] < kMaxLevel && sways[k] >= kComparable * most &&
        (best == kNoAxis || widths[k] > widths[best]))
      best = k;
  return best;
}

bool Subdivision::divisible(const CellId id, const double resolution) const {
  const Cell& cell = cells_[id];
  const bool open = cell.label == Label::kMixed || cell.label == Label::kStar;
  return open && !cell.exhausted && cell.split_axis != kNoAxis &&
         static_cast<double>(cell.split_width) > resolution;
}

void Subdivision::count(const Classification& found) {
  ++statistics_.labelled_cells;
  if (found.label == Label::kFull && found.joint) ++statistics_.joint_cells;
  const bool star_asked = found.label == Label::kStar || found.label == Label::kMixed;
  if (star_asked && labeller_.ablation().star) ++statistics_.star_tests;
}

// Moves what stands behind the label to where it is kept.
void Subdivision::keep(Classification& found, Cell& cell) {
  if (found.label == Label::kFull && found.joint) {
    cell.joint = true;
    cell.proof = static_cast<std::uint32_t>(proofs_.size());
    proofs_.push_back(std::move(*found.joint));
    proof_bytes_ += proofs_.back().bytes();
    return;
  }
  if (found.label == Label::kFull) cell.witness = found.witness;
  if (found.label == Label::kStar) {
    cell.guard = static_cast<std::uint32_t>(guards_.size());
    grow(guards_);
    guards_.push_back(found.guard);
  }
  if (found.label == Label::kStar || found.label == Label::kMixed)
    cell.list = store_.store(found.undecided);
}

Cell Subdivision::make_cell(const CellBox& box, const ConstraintView& parent) {
  const Extent extent = extent_of(box);
  const pdg::Motion motion = motion_of(space_, extent);
  posed_.turn_to(rotation_of(space_, extent));
  Classification found = classify(labeller_, motion, posed_, parent, kCellQuestions, scratch_);
  count(found);
  Cell cell;
  cell.box = box;
  cell.label = found.label;
  keep(found, cell);
  scratch_.room = std::move(found.undecided);
  const std::array<double, 3> widths{motion.g1_length, motion.g2_length,
                                     found.turning_radius * motion.half_angle};
  const Axis axis = best_axis(box, settling_sway(box, found), widths);
  const double radius = found.motion_radius;
  const double relative = radius / labeller_.robot().reach;
  cell.split_axis = static_cast<std::uint8_t>(axis);
  cell.split_width = axis == kNoAxis ? 0.0F : static_cast<float>(widths[axis]);
  cell.size = static_cast<float>(relative);
  cell.cost = static_cast<float>(
      cost_({cell.label, relative, found.separation / radius, thinness(widths, radius)}));
  return cell;
}

CellId Subdivision::split(const CellId id) {
  const Axis axis = cells_[id].split_axis;
  const Halves halves = halve(cells_[id].box, axis);
  const ConstraintView list = undecided(id);
  parent_list_.pairs.assign(list.pairs.begin(), list.pairs.end());
  parent_list_.constraints.assign(list.constraints.begin(), list.constraints.end());
  store_.release(cells_[id].list);
  const std::vector<CellId> old = std::move(cells_[id].neighbours);
  neighbour_bytes_ -= old.capacity() * sizeof(CellId);

  const auto upper = static_cast<CellId>(cells_.size());
  grow(cells_);
  grow(branches_);
  const std::uint32_t place = cells_[id].branch;
  const auto branch = static_cast<std::uint32_t>(branches_.size());
  branches_.push_back({kLeaf | id, kLeaf | upper, axis});
  if ((place & kRoot) != 0)
    roots_[place & ~kRoot] = branch;
  else
    (place % 2 == 0 ? branches_[place / 2].lower : branches_[place / 2].upper) = branch;

  cells_[id] = make_cell(halves.lower, view(parent_list_));
  cells_.push_back(make_cell(halves.upper, view(parent_list_)));
  cells_[id].branch = 2 * branch;
  cells_[upper].branch = 2 * branch + 1;
  adopt_neighbours(id, upper, halves, axis, old);
  return upper;
}

void Subdivision::add_neighbour(const CellId to, const CellId neighbour) {
  std::vector<CellId>& list = cells_[to].neighbours;
  const std::size_t before = list.capacity();
  if (list.size() == before) list.reserve(before + std::max<std::size_t>(4, before / 2));
  list.push_back(neighbour);
  neighbour_bytes_ += (list.capacity() - before) * sizeof(CellId);
}

void Subdivision::link(const CellId a, const CellId b) {
  add_neighbour(a, b);
  add_neighbour(b, a);
}

// The lower half has the parent's id, which its neighbours' lists hold already.
void Subdivision::adopt_neighbours(const CellId lower, const CellId upper, const Halves& halves,
                                   const Axis axis, const std::vector<CellId>& old) {
  const bool lower_open = cells_[lower].label != Label::kFull;
  const bool upper_open = cells_[upper].label != Label::kFull;
  below_.clear();
  above_.clear();
  for (const CellId neighbour : old) {
    const Touched touched = touched_halves(halves, cells_[neighbour].box, axis);
    const bool below = lower_open && touched.lower;
    const bool above = upper_open && touched.upper;
    if (below) below_.push_back(neighbour);
    if (above) above_.push_back(neighbour);
    if (below && above)
      add_neighbour(neighbour, upper);
    else if (above)
      *find_last(cells_[neighbour].neighbours, lower) = upper;
    else if (!below)
      erase_value(cells_[neighbour].neighbours, lower);
  }
  if (lower_open && upper_open) {
    below_.push_back(upper);
    above_.push_back(lower);
  }
  cells_[lower].neighbours.assign(below_.begin(), below_.end());
  cells_[upper].neighbours.assign(above_.begin(), above_.end());
  neighbour_bytes_ +=
      (cells_[lower].neighbours.capacity() + cells_[upper].neighbours.capacity()) * sizeof(CellId);
}

bool Subdivision::linked(const CellId a, const CellId b) const {
  const std::vector<CellId>& of_a = cells_[a].neighbours;
  const std::vector<CellId>& of_b = cells_[b].neighbours;
  return of_a.size() <= of_b.size() ? std::find(of_a.begin(), of_a.end(), b) != of_a.end()
                                    : std::find(of_b.begin(), of_b.end(), a) != of_b.end();
}

bool Subdivision::connected(const std::span<const CellId> from,
                            const std::span<const CellId> to) const {
  std::vector<bool> seen(cells_.size());
  std::vector<CellId> open;
  const auto visit = [&](const CellId cell) {
    if (seen[cell] || cells_[cell].label == Label::kFull) return;
    seen[cell] = true;
    open.push_back(cell);
  };
  for (const CellId cell : from) visit(cell);
  while (!open.empty()) {
    const CellId cell = open.back();
    open.pop_back();
    for (const CellId next : cells_[cell].neighbours) visit(next);
  }
  return std::any_of(to.begin(), to.end(), [&](const CellId cell) { return seen[cell]; });
}

void Subdivision::mark_exhausted(const CellId id) {
  cells_[id].exhausted = true;
  any_exhausted_ = true;
}

void Subdivision::clear_exhausted() {
  if (!std::exchange(any_exhausted_, false)) return;
  for (Cell& cell : cells_) cell.exhausted = false;
}

void Subdivision::disconnect(const CellId a, const CellId b) {
  erase_value(cells_[a].neighbours, b);
  erase_value(cells_[b].neighbours, a);
}

}  // namespace planner
