#include "edge_runs.hpp"

#include <algorithm>
#include <cmath>

#include "tuning.hpp"

namespace planner {

EdgeRuns::EdgeRuns(const Polygon& polygon, const pdg::Frame& frame) {
  for (const pdg::Ring& ring : polygon.rings) {
    const std::size_t begin = points_.size();
    for (const Vec2 p : ring) points_.push_back(pdg::to_frame(frame, p));
    const std::size_t end = points_.size();
    points_.push_back(points_[begin]);
    add_runs(begin, end);
  }
}

void EdgeRuns::add_runs(const std::size_t begin, const std::size_t end) {
  for (std::size_t first = begin; first < end; first += kEdgesPerRun) {
    Run run{
        {INFINITY, INFINITY}, {-INFINITY, -INFINITY}, first, std::min(first + kEdgesPerRun, end)};
    for (std::size_t k = run.begin; k <= run.end; ++k) {
      const Vec2 p = points_[k];
      run.low = {std::min(run.low.x, p.x), std::min(run.low.y, p.y)};
      run.high = {std::max(run.high.x, p.x), std::max(run.high.y, p.y)};
    }
    runs_.push_back(run);
  }
}

bool EdgeRuns::contains(const Vec2 point) const {
  bool inside = false;
  for (const Run& run : runs_) {
    if (point.y < run.low.y || point.y > run.high.y || point.x > run.high.x) continue;
    for (std::size_t k = run.begin; k < run.end; ++k) {
      const Vec2 p = points_[k];
      const Vec2 q = points_[k + 1];
      if ((p.y > point.y) == (q.y > point.y)) continue;
      inside ^= point.x < p.x + (point.y - p.y) / (q.y - p.y) * (q.x - p.x);
    }
  }
  return inside;
}

}  // namespace planner
