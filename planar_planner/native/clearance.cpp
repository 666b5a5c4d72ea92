#include "clearance.hpp"

#include <algorithm>
#include <queue>
#include <vector>

#include "nearby.hpp"
#include "pdg/native/separation.hpp"

namespace planner {

namespace {

// The largest lower bound of the pair's separating-axis functions over the motion.
double pair_separation(const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                       const pdg::Motion& motion, std::vector<pdg::Constraint>& axes) {
  axes.clear();
  pdg::all_constraints(*a.piece, b, axes);
  const double error = pdg::separation_error(*a.piece, b, motion);
  double best = -INFINITY;
  for (pdg::Constraint& axis : axes)
    best = std::max(best, pdg::constraint_range(a, b, motion, error, axis).lo - error);
  return best;
}

class Probe {
 public:
  Probe(const Problem& problem, ObstacleTree& tree, const Pose& from, const Pose& to)
      : problem_(problem), tree_(tree), from_(from), to_(to) {}

  // Certified lower bound over the interval, at most `cap`; 0 if the interval turns too far.
  double over(const Interval interval, const double cap) {
    const pdg::Motion motion = motion_along(problem_, from_, to_, interval);
    if (motion.half_angle > 1.0) return 0.0;
    const double middle = 0.5 * (interval.begin + interval.end);
    const pdg::Rotation rotation = rotation_at(between(from_, to_, middle).theta);
    pose(problem_.robot, rotation, posed_);
    double least = cap;
    visit_nearby_pairs(problem_.robot, tree_, motion, rotation, cap,
                       [&](const std::uint32_t obstacle, const std::size_t robot) {
                         least = std::min(
                             least, pair_separation(posed_piece(problem_.robot, posed_, robot),
                                                    tree_.piece(obstacle), motion, axes_));
                       });
    return std::max(least, 0.0);
  }

  // The separation at one configuration, looking no farther than needed.
  double at(const double s, const double cap) {
    const double farthest = 4.0 * (problem_.domain.reach + problem_.robot.reach);
    double within = std::min(cap, problem_.robot.reach);
    for (;;) {
      const double found = over({s, s}, within);
      if (found < within || within >= cap) return found;
      if (within >= farthest) return cap;
      within = std::min(4.0 * within, cap);
    }
  }

 private:
  const Problem& problem_;
  ObstacleTree& tree_;
  const Pose& from_;
  const Pose& to_;
  pdg::PosedRobot posed_;
  std::vector<pdg::Constraint> axes_;
};

struct Open {
  double bound;
  Interval interval;
  bool operator<(const Open& other) const { return bound > other.bound; }
};

}  // namespace

void bound_clearance(const Problem& problem, ObstacleTree& tree, const Pose& from, const Pose& to,
                     const double tolerance, int intervals, ClearanceBounds& clearance) {
  Probe probe(problem, tree, from, to);
  std::priority_queue<Open> open;
  clearance.upper = std::min(clearance.upper, probe.at(0.5, clearance.upper));
  if (clearance.upper == INFINITY) return;
  open.push({probe.over({0.0, 1.0}, clearance.upper), {0.0, 1.0}});
  while (open.top().bound < (1.0 - tolerance) * clearance.upper && intervals-- > 0) {
    const Interval i = open.top().interval;
    open.pop();
    const double middle = 0.5 * (i.begin + i.end);
    for (const Interval half : {Interval{i.begin, middle}, Interval{middle, i.end}}) {
      clearance.upper =
          std::min(clearance.upper, probe.at(0.5 * (half.begin + half.end), clearance.upper));
      open.push({probe.over(half, clearance.upper), half});
    }
  }
  clearance.lower = std::min(clearance.lower, open.top().bound);
}

}  // namespace planner
