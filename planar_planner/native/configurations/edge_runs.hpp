// A polygon's boundary, with boxes round runs of its edges: overlap without convex pieces, in plain
// doubles. For hints only.
#pragma once

#include <cstddef>
#include <vector>

#include "pdg/native/geometry/convex_piece.hpp"
#include "planar_planner/native/world/problem.hpp"

namespace planner {

class EdgeRuns {
 public:
  // The polygon is mapped into the frame.
  EdgeRuns(const Polygon& polygon, const pdg::Frame& frame);

  // Is visit(p, q) true for any edge whose run's box meets [low, high]?
  template <class Visit>
  [[nodiscard]] bool any_edge(const Vec2 low, const Vec2 high, const Visit& visit) const {
    for (const Run& run : runs_) {
      if (run.low.x > high.x || run.low.y > high.y || run.high.x < low.x || run.high.y < low.y)
        continue;
      for (std::size_t k = run.begin; k < run.end; ++k)
        if (visit(points_[k], points_[k + 1])) return true;
    }
    return false;
  }

  [[nodiscard]] std::size_t count() const { return runs_.size(); }

  // Decided by the parity of the crossings of a ray to the right.
  [[nodiscard]] bool contains(Vec2 point) const;

 private:
  struct Run {
    Vec2 low, high;
    std::size_t begin, end;  // edge k runs from point k to point k + 1
  };

  void add_runs(std::size_t begin, std::size_t end);

  std::vector<Vec2> points_;  // every ring closed by its first point
  std::vector<Run> runs_;
};

}  // namespace planner
