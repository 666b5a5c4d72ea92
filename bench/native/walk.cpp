#include "walk.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/search/query.hpp"
#include "planar_planner/native/search/search.hpp"

namespace bench {

namespace {

using planner::ConstraintList;
using planner::Extent;
using planner::Label;
using planner::Subdivision;

// Theta starts at quarter turns, as in the planner.
constexpr int kRootLevel = 2;

struct Judged {
  Label label;
  std::shared_ptr<ConstraintList> list;  // MIXED, STAR
};

// Labels the cell, applies every query (only `driver` where no truth is asked for), and decides the
// truth unless it is inherited.
Judged judge(World& world, Seen& seen, const Query driver, const WalkLimits& limits) {
  const Extent& box = seen.visit.box;
  const pdg::Motion motion = motion_of(world.space, box);
  const pdg::Rotation rotation = rotation_of(world.space, box);
  Judged out;
  out.list = std::make_shared<ConstraintList>();
  planner::LabelResult result =
      world.labeller.label(motion, world.posed_at(rotation), view(*seen.visit.parent));
  out.label = result.label;
  *out.list = std::move(result.undecided);
  for (std::size_t q = 0; q < kQueries; ++q)
    if (limits.truth || static_cast<Query>(q) == driver)
      seen.culled[q] = proves(world, seen.visit, static_cast<Query>(q));
  if (out.label == Label::kMixed &&
      find_guard(world.tree, motion, world.posed_at(rotation), view(*out.list), world.scratch.star))
    out.label = Label::kStar;
  if (seen.inherited || out.label == Label::kFull)
    seen.truth = Truth::kObstacle;
  else if (out.label == Label::kFree || !limits.truth)
    seen.truth = Truth::kNotAll;
  else
    seen.truth = refine(world, box, *out.list, limits.budget, true);
  return out;
}

std::array<Extent, 8> octants(const Extent& box, const bool rotation) {
  std::array<Extent, 8> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = box;
    for (planner::Axis k = 0; k < planner::kNoAxis; ++k) {
      if (k == planner::kTheta && !rotation) continue;
      parts[i].size[k] = box.size[k] / 2;
      if ((i >> k) % 2 == 1) parts[i].low[k] += box.size[k] / 2;
    }
  }
  return parts;
}

std::vector<Extent> roots(const bool rotation) {
  std::vector<Extent> boxes;
  const std::uint64_t parts = rotation ? std::uint64_t{1} << kRootLevel : 1;
  for (std::uint64_t i = 0; i < parts; ++i) {
    const std::uint64_t size = planner::kUnit / parts;
    boxes.push_back({{0, 0, i * size}, {planner::kUnit, planner::kUnit, size}});
  }
  return boxes;
}

// The subdivision's kd-tree again, with what each cell inherits.
void collect(World& world, const Subdivision& subdivision, const std::uint32_t node,
             const planner::CellBox& box, Seen seen, const WalkLimits& limits,
             std::vector<Seen>& out) {
  seen.visit.box = extent_of(box);
  const Judged judged = judge(world, seen, Query::kLabel, limits);
  out.push_back(seen);
  if ((node & Subdivision::kLeaf) != 0) return;
  const Subdivision::Branch branch = subdivision.branch(node);
  const planner::Halves halves = halve(box, branch.axis);
  Seen child;
  child.level = seen.level + 1;
  child.inherited = seen.truth == Truth::kObstacle;
  child.visit.parent = judged.list;
  collect(world, subdivision, branch.lower, halves.lower, child, limits, out);
  collect(world, subdivision, branch.upper, halves.upper, child, limits, out);
}

}  // namespace

std::vector<Seen> walk_levels(World& world, const Query driver, const WalkLimits& limits) {
  const auto whole = std::make_shared<ConstraintList>();
  world.labeller.root_list(*whole);
  std::vector<Seen> out;
  std::vector<Seen> level;
  for (const Extent& box : roots(world.space.rotation)) {
    Seen seen;
    seen.visit = {box, whole};
    level.push_back(seen);
  }
  const std::size_t parts = world.space.rotation ? 8 : 4;
  while (!level.empty() && out.size() + level.size() <= limits.cells) {
    std::vector<Seen> next;
    for (Seen& seen : level) {
      const Judged judged = judge(world, seen, driver, limits);
      const bool open = judged.label == Label::kMixed || judged.label == Label::kFull;
      if (open && !seen.culled[static_cast<std::size_t>(driver)]) {
        const auto octant = octants(seen.visit.box, world.space.rotation);
        for (std::size_t i = 0; i < parts; ++i) {
          Seen child;
          // A FULL cell leaves no list: what misses it starts from its parent's again.
          child.visit = {octant[i], judged.label == Label::kFull ? seen.visit.parent : judged.list};
          child.level = seen.level + 1;
          child.inherited = seen.truth == Truth::kObstacle;
          next.push_back(child);
        }
      }
      out.push_back(seen);
    }
    level = std::move(next);
  }
  return out;
}

std::vector<Seen> walk_search(World& world, const Task& task, const WalkLimits& limits) {
  const planner::Limits query_limits;
  planner::SegmentTest segments(world.problem, world.labeller, world.statistics);
  Subdivision subdivision(world.space, world.labeller, world.statistics, planner::crossing_cost);
  planner::FaceTest faces(subdivision, world.labeller, world.statistics);
  planner::Query query(
      task.start, task.goal, nullptr, query_limits, [] { return 0.0; },
      [&](const planner::Usage& usage, const auto&) -> std::optional<planner::StopReason> {
        if (usage.cells < query_limits.max_cells && usage.memory_bytes < query_limits.max_memory)
          return std::nullopt;
        return planner::StopReason::kMaxCells;
      });
  planner::Search(world.problem, world.tree, subdivision, faces, segments, world.statistics, query)
      .run();
  Seen root;
  const auto whole = std::make_shared<ConstraintList>();
  world.labeller.root_list(*whole);
  root.visit.parent = whole;
  std::vector<Seen> out;
  for (std::size_t i = 0; i < subdivision.roots().size(); ++i)
    collect(world, subdivision, subdivision.roots()[i], subdivision.root_box(i), root, limits, out);
  return out;
}

}  // namespace bench
