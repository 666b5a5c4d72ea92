#include "solid_regions.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>

namespace planner {

namespace {

bool is_free(const Subdivision& subdivision, const CellId id) {
  return subdivision.cell(id).label == Label::kFree;
}

// All configurations on a face of two FREE leaves are free.
bool open_link(const Subdivision& subdivision, FaceTest& faces, const CellId a, const CellId b) {
  if (!subdivision.cell(a).solid() || !subdivision.cell(b).solid()) return false;
  if (is_free(subdivision, a) && is_free(subdivision, b)) return true;
  return faces.test(a, b).state == LinkState::kOpen;
}

// Numbers the groups of leaves that `holds` accepts and `linked` joins; kNoRegion for the others.
template <class Holds, class Linked>
std::vector<std::uint32_t> groups(const Subdivision& subdivision, const Holds& holds,
                                  const Linked& linked) {
  std::vector<std::uint32_t> group(subdivision.size(), kNoRegion);
  std::uint32_t count = 0;
  std::vector<CellId> open;
  for (CellId seed = 0; seed < subdivision.size(); ++seed) {
    if (group[seed] != kNoRegion || !holds(seed)) continue;
    open.assign(1, seed);
    group[seed] = count;
    while (!open.empty()) {
      const CellId here = open.back();
      open.pop_back();
      for (const CellId next : subdivision.cell(here).neighbours) {
        if (group[next] != kNoRegion || !holds(next) || !linked(here, next)) continue;
        group[next] = count;
        open.push_back(next);
      }
    }
    ++count;
  }
  return group;
}

bool holds_angle(const CellBox& box, const std::uint64_t turns) {
  const bool inside = box.low[kTheta] <= turns && turns <= box.high(kTheta);
  return inside || (turns == 0 && box.high(kTheta) == kUnit);
}

double area(const CellBox& box) {
  return static_cast<double>(box.size(kX)) * static_cast<double>(box.size(kY));
}

}  // namespace

std::vector<std::uint32_t> solid_regions(const Subdivision& subdivision, FaceTest& faces) {
  return groups(
      subdivision, [&](const CellId id) { return subdivision.cell(id).solid(); },
      [&](const CellId a, const CellId b) { return open_link(subdivision, faces, a, b); });
}

std::vector<CellId> free_leaves_at(const Subdivision& subdivision, const int quarters) {
  const std::uint64_t turns = kUnit / 4 * static_cast<std::uint64_t>(quarters);
  const auto group = groups(
      subdivision,
      [&](const CellId id) {
        return is_free(subdivision, id) && holds_angle(subdivision.cell(id).box, turns);
      },
      [](CellId, CellId) { return true; });
  std::vector<CellId> largest;
  const auto larger = [&](const CellId a, const CellId b) {
    const double of_a = area(subdivision.cell(a).box);
    const double of_b = area(subdivision.cell(b).box);
    return of_a != of_b ? of_a > of_b : a < b;
  };
  for (CellId id = 0; id < subdivision.size(); ++id) {
    if (group[id] == kNoRegion) continue;
    if (group[id] >= largest.size()) largest.resize(group[id] + 1, kNoCell);
    CellId& best = largest[group[id]];
    if (best == kNoCell || larger(id, best)) best = id;
  }
  std::sort(largest.begin(), largest.end(), larger);
  return largest;
}

std::vector<CellId> solid_way(const Subdivision& subdivision, FaceTest& faces, const CellId from,
                              const CellId to) {
  std::vector<CellId> before(subdivision.size(), kNoCell);
  std::deque<CellId> open{from};
  before[from] = from;
  while (!open.empty() && before[to] == kNoCell) {
    const CellId here = open.front();
    open.pop_front();
    for (const CellId next : subdivision.cell(here).neighbours) {
      if (before[next] != kNoCell || !open_link(subdivision, faces, here, next)) continue;
      before[next] = here;
      open.push_back(next);
    }
  }
  std::vector<CellId> way;
  if (before[to] == kNoCell) return way;
  for (CellId at = to; at != from; at = before[at]) way.push_back(at);
  way.push_back(from);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace planner
