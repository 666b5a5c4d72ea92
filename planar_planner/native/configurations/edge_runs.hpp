// A polygon's boundary, with boxes round runs of its edges: overlap without convex pieces, in plain
// doubles. For hints only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pdg/native/geometry/convex_piece.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace planner {

class EdgeRuns {
 public:
  // The polygon is mapped into the frame.
  EdgeRuns(const Polygon& polygon, const pdg::Frame& frame);

  // kMet if meets(p, q) for any edge whose bounding box meets [low, high]; else the least gap
  // between that box and those of edges, 0 if one meets it.
  static constexpr double kMet = -1.0;
  template <class Meets>
  [[nodiscard]] double gap(const Vec2 low, const Vec2 high, const Meets& meets) const {
    double least = INFINITY;
    for (const Run& run : runs_) {
      const double to_run = box_gap(low, high, run.low, run.high);
      if (to_run > 0.0) {
        least = std::min(least, to_run);
        continue;
      }
      for (std::size_t k = run.begin; k < run.end; ++k) {
        const Vec2 p = points_[k];
        const Vec2 q = points_[k + 1];
        const double to_edge = box_gap(low, high, {std::min(p.x, q.x), std::min(p.y, q.y)},
                                       {std::max(p.x, q.x), std::max(p.y, q.y)});
        if (to_edge < 0.0 && meets(p, q)) return kMet;
        least = std::min(least, std::max(to_edge, 0.0));
      }
    }
    return least;
  }

  [[nodiscard]] std::size_t count() const { return runs_.size(); }

  // Decided by the parity of the crossings of a ray to the right.
  [[nodiscard]] bool contains(Vec2 point) const;

 private:
  struct Run {
    Vec2 low, high;
    std::size_t begin, end;  // edge k runs from point k to point k + 1
  };

  // Negative if the boxes overlap.
  static double box_gap(const Vec2 a_low, const Vec2 a_high, const Vec2 b_low, const Vec2 b_high) {
    return std::max(std::max(a_low.x - b_high.x, b_low.x - a_high.x),
                    std::max(a_low.y - b_high.y, b_low.y - a_high.y));
  }

  void add_runs(std::size_t begin, std::size_t end);

  std::vector<Vec2> points_;  // every ring closed by its first point
  std::vector<Run> runs_;
};

}  // namespace planner
