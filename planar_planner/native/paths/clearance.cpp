#include "clearance.hpp"

#include <algorithm>
#include <queue>
#include <vector>

#include "pdg/native/separation/separation.hpp"
#include "planar_planner/native/configurations/nearby.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

// The largest lower bound of the pair's separating-axis functions over the motion; of those that
// reach `enough`, the first.
double pair_separation(const pdg::PosedPiece& a, const pdg::ConvexPiece& b,
                       const pdg::Motion& motion, const double enough,
                       std::vector<pdg::Constraint>& axes) {
  axes.clear();
  pdg::all_constraints(*a.piece, b, axes);
  const double error = pdg::separation_error(*a.piece, b, motion);
  double best = -INFINITY;
  for (pdg::Constraint& axis : axes) {
    best = std::max(best, pdg::constraint_range(a, b, motion, error, axis).lo - error);
    if (best >= enough) break;
  }
  return best;
}

class Probe {
 public:
  Probe(const ScaledProblem& problem, ObstacleTree& tree, const ScaledConfiguration& from,
        const ScaledConfiguration& to)
      : problem_(problem), tree_(tree), from_(from), to_(to), posed_(problem.robot) {}

  // Certified lower bound over the interval, at most `cap`; 0 if the interval turns too far.
  double over(const Interval interval, const double cap) {
    return over(interval, cap, [](std::uint32_t) { return INFINITY; });
  }

  // The separation at one configuration, looking no farther than needed.
  double at(const double s, const double cap) {
    return nearest(cap, [&](const double within) { return over({s, s}, within); });
  }

  // The same, but of polygons that nobody has decomposed their hulls, if those are far enough.
  double at_about(const double s, const double cap) {
    const double far = kFarHull * problem_.robot.reach;
    const pdg::Motion rest = motion_along(problem_, from_, to_, {s, s});
    const auto of_hull = [&](const std::uint32_t node) {
      const double gap = hull_separation(node, rest);
      return gap >= far ? gap : INFINITY;
    };
    return nearest(cap, [&](const double within) { return over({s, s}, within, of_hull); });
  }

 private:
  // `known` gives a node's separation where it need not be opened, else infinity.
  template <class Known>
  double over(const Interval interval, const double cap, const Known& known) {
    const pdg::Motion motion = motion_along(problem_, from_, to_, interval);
    if (motion.half_angle > 1.0) return 0.0;
    const double s = 0.5 * (interval.begin + interval.end);
    const pdg::Rotation rotation = rotation_at(between(from_, to_, s).theta);
    posed_.turn_to(rotation);
    double least = cap;
    const auto meet = [&](const pdg::ConvexPiece& obstacle, const std::size_t robot) {
      least = std::min(least, pair_separation(posed_.piece(robot), obstacle, motion, least, axes_));
    };
    visit_nearby_pairs(
        problem_.robot, tree_, motion, rotation, cap,
        [&](const std::uint32_t obstacle, const std::size_t robot) {
          meet(tree_.piece(obstacle), robot);
        },
        [&](const std::uint32_t node) {
          const double separation = known(node);
          least = std::min(least, separation);
          return separation < INFINITY;
        });
    return std::max(least, 0.0);
  }

  // The separation of the robot, which `over` has posed for this configuration, from the hull of
  // the polygon that the node is.
  double hull_separation(const std::uint32_t node, const pdg::Motion& rest) {
    const pdg::ConvexPiece* const hull = tree_.hull(node);
    if (hull == nullptr) return -INFINITY;
    double least = INFINITY;
    for (std::size_t i = 0; i < problem_.robot.body_pieces(); ++i)
      least = std::min(least, pair_separation(posed_.piece(i), *hull, rest, INFINITY, axes_));
    return least;
  }

  template <class Within>
  double nearest(const double cap, const Within& found_within) {
    const double farthest = 4.0 * (problem_.domain.reach + problem_.robot.reach);
    double within = std::min(cap, problem_.robot.reach);
    for (;;) {
      const double found = found_within(within);
      if (found < within || within >= cap) return found;
      if (within >= farthest) return cap;
      within = std::min(4.0 * within, cap);
    }
  }

  const ScaledProblem& problem_;
  ObstacleTree& tree_;
  ScaledConfiguration from_;
  ScaledConfiguration to_;
  PosedRobot posed_;
  std::vector<pdg::Constraint> axes_;
};

struct Open {
  double bound;
  std::size_t segment;
  Interval interval;
  bool operator<(const Open& other) const { return bound > other.bound; }
};

double middle(const Interval i) {
  return 0.5 * (i.begin + i.end);
}

}  // namespace

double sampled_clearance(const ScaledProblem& problem, ObstacleTree& tree,
                         const std::vector<ScaledConfiguration>& path) {
  double least = INFINITY;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    least = std::min(least, Probe(problem, tree, path[i], path[i + 1]).at_about(0.5, least));
  return least;
}

// Best first over all segments at once, so that where there is much room nothing is refined.
ClearanceBounds bound_clearance(const ScaledProblem& problem, ObstacleTree& tree,
                                const std::vector<ScaledConfiguration>& path,
                                const double tolerance, const int intervals,
                                const std::vector<double>& off) {
  ClearanceBounds clearance;
  std::vector<Probe> probes;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    probes.emplace_back(problem, tree, path[i], path[i + 1]);
  const auto less = [&](const std::size_t i) { return off.empty() ? 0.0 : off[i]; };
  const auto look_at = [&](const std::size_t segment, const double s) {
    const double by = less(segment);
    const double found = probes[segment].at(s, clearance.upper + by) - by;
    clearance.upper = std::min(clearance.upper, std::max(found, 0.0));
  };
  for (std::size_t i = 0; i < probes.size(); ++i) look_at(i, 0.5);
  if (clearance.upper == INFINITY) return clearance;
  std::priority_queue<Open> open;
  const auto push = [&](const std::size_t segment, const Interval interval) {
    const double by = less(segment);
    const double found = probes[segment].over(interval, clearance.upper + by) - by;
    open.push({std::max(found, 0.0), segment, interval});
  };
  for (std::size_t i = 0; i < probes.size(); ++i) push(i, {0.0, 1.0});
  std::size_t left = static_cast<std::size_t>(intervals) * probes.size();
  while (open.top().bound < (1.0 - tolerance) * clearance.upper && left-- > 0) {
    const Open worst = open.top();
    open.pop();
    const Interval i = worst.interval;
    for (const Interval half : {Interval{i.begin, middle(i)}, Interval{middle(i), i.end}}) {
      look_at(worst.segment, middle(half));
      push(worst.segment, half);
    }
  }
  clearance.lower = open.top().bound;
  return clearance;
}

}  // namespace planner
