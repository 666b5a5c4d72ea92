#include "subdivision.hpp"

#include <algorithm>
#include <cmath>

namespace planner {

namespace {

double motion_radius(const pdg::Motion& m, const double turning_radius) {
  return pdg::norm({m.g1.x, m.g2.y}) + turning_radius * m.half_angle;
}

void erase_value(std::vector<CellId>& list, const CellId value) {
  const auto at = std::find(list.begin(), list.end(), value);
  if (at == list.end()) return;
  *at = list.back();
  list.pop_back();
}

}  // namespace

Subdivision::Subdivision(const CellSpace& space, Labeller& labeller, Statistics& statistics)
    : space_(space), labeller_(labeller), statistics_(statistics),
      star_(labeller.robot(), labeller.tree()), joint_(labeller.robot(), labeller.tree()) {
  ConstraintList root;
  labeller_.root_list(root);
  // Quarter turns at most: two cells then share at most one face, and half-angles stay below pi/2.
  const int level = space.rotation ? 2 : 0;
  for (std::uint64_t i = 0; i < (std::uint64_t{1} << level); ++i) {
    CellBox box;
    box.level[kTheta] = static_cast<std::uint8_t>(level);
    box.low[kTheta] = i * box.size(kTheta);
    add_cell(box, view(root));
  }
  for (CellId a = 0; a < cells_.size(); ++a)
    for (CellId b = 0; b < cells_.size(); ++b) {
      int axis = 0;
      if (a != b && cells_[a].label != Label::kFull && cells_[b].label != Label::kFull &&
          adjacent(cells_[a].box, cells_[b].box, axis))
        cells_[a].neighbours.push_back(b);
    }
}

std::uint64_t Subdivision::guard_turns(const CellId id) const {
  const CellBox& box = cells_[id].box;
  return box.low[kTheta] + (space_.rotation ? box.size(kTheta) / 2 : 0);
}

std::size_t Subdivision::bytes() const {
  return cells_.capacity() * sizeof(Cell) + guards_.capacity() * sizeof(Vec2) + store_.bytes() +
         neighbour_bytes_;
}

CellId Subdivision::locate(const std::array<std::uint64_t, 3>& point) const {
  CellId id = 0;
  while (point[kTheta] >= cells_[id].box.high(kTheta)) ++id;  // roots come first
  while (!cells_[id].leaf()) {
    const CellId first = cells_[id].children;
    const CellBox& upper = cells_[first + 1].box;
    const CellBox& lower = cells_[first].box;
    bool in_upper = true;
    for (int k = 0; k < 3; ++k)
      if (upper.low[k] != lower.low[k]) in_upper = point[k] >= upper.low[k];
    id = in_upper ? first + 1 : first;
  }
  return id;
}

int Subdivision::widest_axis(const Cell& cell) const {
  const pdg::Motion m = motion_of(space_, extent_of(cell.box));
  const std::array<double, 3> width{m.g1.x, m.g2.y,
                                    static_cast<double>(cell.turning_radius) * m.half_angle};
  int widest = -1;
  for (int k = 0; k < (space_.rotation ? 3 : 2); ++k)
    if (cell.box.level[k] < kMaxLevel && (widest < 0 || width[k] > width[widest])) widest = k;
  return widest;
}

bool Subdivision::divisible(const CellId id, const double resolution) const {
  const Cell& cell = cells_[id];
  return !cell.exhausted && widest_axis(cell) >= 0 &&
         static_cast<double>(cell.size) * labeller_.robot().reach > resolution;
}

CellId Subdivision::add_cell(const CellBox& box, const ConstraintView& parent) {
  const Stopwatch watch(statistics_.seconds.labelling);
  ++statistics_.labelled_cells;
  const Extent extent = extent_of(box);
  const pdg::Motion motion = motion_of(space_, extent);
  const pdg::PosedRobot& posed = labeller_.posed(rotation_of(space_, extent));
  const LabelResult result = labeller_.label(motion, posed, parent, child_list_);

  Cell cell;
  cell.box = box;
  cell.label = result.label;
  cell.witness = result.witness;
  cell.turning_radius = static_cast<float>(result.turning_radius);
  const double radius = motion_radius(motion, result.turning_radius);
  cell.size = static_cast<float>(radius / labeller_.robot().reach);
  if (result.label == Label::kMixed) {
    cell.separation = static_cast<float>(result.separation / radius);
    // A cell whose centre looks free is not FULL; the rest is worth both tests.
    if (result.separation < 0.0 && joint_.obstructs(motion, posed, view(child_list_))) {
      cell.label = Label::kFull;
      cell.joint = true;
      ++statistics_.joint_cells;
    } else if (++statistics_.star_tests; const auto guard = star_.find_guard(motion, posed, view(child_list_))) {
      cell.label = Label::kStar;
      cell.guard = static_cast<std::uint32_t>(guards_.size());
      guards_.push_back(*guard);
    }
    if (cell.label != Label::kFull) cell.list = store_.store(child_list_);
  }
  cell.cost = static_cast<float>(crossing_cost(cell));
  cells_.push_back(std::move(cell));
  return static_cast<CellId>(cells_.size() - 1);
}

CellId Subdivision::split(const CellId id) {
  const Halves halves = halve(cells_[id].box, widest_axis(cells_[id]));
  const ConstraintView undecided = store_.get(cells_[id].list);
  parent_list_.pairs.assign(undecided.pairs.begin(), undecided.pairs.end());
  parent_list_.constraints.assign(undecided.constraints.begin(), undecided.constraints.end());
  store_.release(cells_[id].list);
  const CellId first = add_cell(halves.lower, view(parent_list_));
  add_cell(halves.upper, view(parent_list_));
  cells_[id].children = first;
  ++inner_;
  adopt_neighbours(id, first);
  return first;
}

void Subdivision::adopt_neighbours(const CellId parent, const CellId first) {
  const std::vector<CellId> old = std::move(cells_[parent].neighbours);
  cells_[parent].neighbours = {};
  neighbour_bytes_ -= old.capacity() * sizeof(CellId);
  const CellId children[2] = {first, first + 1};
  const auto link = [&](const CellId a, const CellId b) {
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      std::vector<CellId>& list = cells_[from].neighbours;
      neighbour_bytes_ -= list.capacity() * sizeof(CellId);
      list.push_back(to);
      neighbour_bytes_ += list.capacity() * sizeof(CellId);
    }
  };
  for (const CellId neighbour : old) erase_value(cells_[neighbour].neighbours, parent);
  for (const CellId child : children) {
    if (cells_[child].label == Label::kFull) continue;
    for (const CellId neighbour : old) {
      int axis = 0;
      if (adjacent(cells_[child].box, cells_[neighbour].box, axis)) link(child, neighbour);
    }
  }
  if (cells_[first].label != Label::kFull && cells_[first + 1].label != Label::kFull)
    link(first, first + 1);
}

void Subdivision::disconnect(const CellId a, const CellId b) {
  erase_value(cells_[a].neighbours, b);
  erase_value(cells_[b].neighbours, a);
}

}  // namespace planner
