// What the planner is made of. All of it is used; benchmarks leave single parts out to measure what
// each is worth. Every combination answers soundly; without some, fewer questions are decided.
#pragma once

#include <cstdint>

namespace planner {

// How a cell is recognised as lying in C-obstacle by one pair of pieces ([PDG] 8.1).
enum class CullingQuery : std::uint8_t {
  kNone,          // not at all
  kPublished,     // PD^t at the centre > Eq. 3 with the whole robot's radius
  kDisplacement,  // PD^t at the centre > displacement bound with the piece's radius
  kPerNormal,     // every separating-axis function negative over the whole cell
};

struct Parts {
  CullingQuery query = CullingQuery::kPerNormal;
  bool star = true;         // star-shaped cells; without: FREE cells only
  bool joint = true;        // FULL by several pairs together
  bool guided = true;       // refine a channel; without: all MIXED cells, level by level
  bool incremental = true;  // mend the search's trees; without: search from scratch every round
  bool hierarchy = true;    // obstacles by a bounding-volume hierarchy; without: all pairs
  bool partition = true;    // disjoint convex pieces; without: a cover of larger, overlapping ones
  bool cheap = true;        // straight and two-leg moves, and discs, before any subdivision
  bool ridge = true;  // paths along the ridge of the clearance; without: channels of cells only
  bool probe = true;  // a first try by RRT-Connect, certified; without: cells only
};

}  // namespace planner
