// A path guessed from a channel that is still MIXED: configurations of its cells pushed onto the
// ridge of the clearance, and joined by certified segments. A gate that is narrow, long and slanted
// against the axes of the cells is passed in a few segments, where cells would have to be as small
// as its clearance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "ridge.hpp"

namespace planner {

// A configuration of one cell that looks free.
struct Foothold {
  ScaledConfiguration q;
  double clearance = 0.0;  // infinite in a solid cell; not positive: none was found
  bool coarse = false;     // what may be in the cell is not known yet: it has to be split
};

class RidgePath {
 public:
  RidgePath(const ScaledProblem& problem, const ObstacleTree& tree, const Subdivision& subdivision,
            SegmentTest& segments, Statistics& statistics)
      : problem_(problem),
        subdivision_(subdivision),
        segments_(segments),
        statistics_(statistics),
        climb_(problem, tree, statistics) {}

  // Waypoints from start to goal, certified. Empty if none were found before about `budget`
  // evaluations of separating-axis functions were spent, or the terminator struck.
  std::vector<Configuration> find(const std::vector<CellId>& channel, const Configuration& start,
                                  const Configuration& goal, std::uint64_t budget,
                                  const Terminator& stop);

  // The parts of a path, for whoever keeps them. Both count as work and stop as `find` does, whose
  // budget begin() sets. A foothold's theta is the cell's own.
  void begin(std::uint64_t budget, const Terminator& stop);
  Foothold foothold(CellId cell);
  // Certified configurations that lead on from one configuration to another near the two cells, the
  // other included. False if the way was not found.
  bool join(const ScaledConfiguration& from, const ScaledConfiguration& to,
            const std::vector<CellId>& cells, std::vector<ScaledConfiguration>& way);

 private:
  // A configuration in or near one of the channel's cells, free as far as plain doubles tell.
  struct Step {
    ScaledConfiguration q;
    std::size_t cell;  // its place in the channel
    double clearance;  // infinite at the ends and in solid cells
  };
  // The way from one foothold to the next.
  struct Gap {
    std::size_t from;
    double clearance;  // of the tighter end; negative: a cell in between has no foothold
    std::vector<ScaledConfiguration> configurations;  // certified, without the first
  };

  bool find_footholds(const std::vector<CellId>& channel);
  Height crest(Height top, double radius, double half_angle);
  [[nodiscard]] ScaledConfiguration middle_of(CellId id, double near) const;
  void list_gaps();
  void look_between(const std::vector<CellId>& channel, const Step& from, const Step& to);
  bool connect(const ScaledConfiguration& from, const ScaledConfiguration& to, int depth,
               std::vector<ScaledConfiguration>& configurations);
  Height between_axes(const ScaledConfiguration& from, const ScaledConfiguration& to,
                      double radius);
  [[nodiscard]] ScaledConfiguration rounded(const ScaledConfiguration& q) const;
  [[nodiscard]] double way(const ScaledConfiguration& from, const ScaledConfiguration& to) const;
  [[nodiscard]] bool spent() const;

  const ScaledProblem& problem_;
  const Subdivision& subdivision_;
  SegmentTest& segments_;
  Statistics& statistics_;
  RidgeClimb climb_;
  std::vector<Step> footholds_;
  std::vector<Gap> gaps_;
  std::vector<PairAxis> scope_;  // what the cells looked at leave undecided
  std::vector<PairAxis> both_;
  std::uint64_t most_ = 0;  // statistics_.axis_work() at which to give up
  const Terminator* stop_ = nullptr;
};

}  // namespace planner
