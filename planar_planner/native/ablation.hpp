// The parts that the planner is made of. All of it is used; benchmarks leave single parts out to
// measure what each is worth. Every combination answers soundly; without some, fewer questions are
// decided.
#pragma once

#include <cstdint>

namespace planner {

// X(enumerator, name in Python): how a cell is recognised as lying in C-obstacle by one pair of
// pieces ([PDG] 8.1).
#define PLANNER_CULLING_QUERIES(X)                                                                \
  X(kNone, "none")                 /* not at all */                                               \
  X(kPublished, "published")       /* PD^t at the centre > Eq. 3 with the whole robot's radius */ \
  X(kDisplacement, "displacement") /* PD^t there > displacement bound, the piece's radius */      \
  X(kPerNormal, "per-normal")      /* every separating-axis function negative over the cell */

// X(name): a part that can be left out.
#define PLANNER_PARTS(X)                                                                       \
  X(star)        /* star-shaped cells; without: FREE cells only */                             \
  X(joint)       /* FULL by several pairs together */                                          \
  X(guided)      /* refine a channel; without: all MIXED cells, level by level */              \
  X(incremental) /* mend the search's trees; without: search from scratch every round */       \
  X(hierarchy)   /* obstacles by a bounding-volume hierarchy; without: all pairs */            \
  X(partition)   /* disjoint convex pieces; without: a cover of larger, overlapping ones */    \
  X(cheap)       /* straight and two-leg moves, and discs, before any subdivision */           \
  X(ridge)       /* paths along the ridge of the clearance; without: channels of cells only */ \
  X(probe)       /* a first try by RRT-Connect, certified; without: cells only */              \
  X(survey)      /* late in a search split only where a channel is stuck */                    \
  X(layers)      /* robots that may not turn, exactly; without: cells only */                  \
  X(shift)       /* far reference points: plan about a point of the body */

#define PLANNER_ENUMERATOR(enumerator, name) enumerator,
enum class CullingQuery : std::uint8_t { PLANNER_CULLING_QUERIES(PLANNER_ENUMERATOR) };
#undef PLANNER_ENUMERATOR

struct Ablation {
  CullingQuery query = CullingQuery::kPerNormal;
#define PLANNER_PART(name) bool name = true;
  PLANNER_PARTS(PLANNER_PART)
#undef PLANNER_PART
};

}  // namespace planner
