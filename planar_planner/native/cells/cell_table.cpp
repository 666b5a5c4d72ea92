#include "cell_table.hpp"

namespace planner {

namespace {

std::array<double, 3> corner(const ScaledProblem& problem, const CellSpace& space,
                             const std::array<std::uint64_t, 3>& point) {
  const Vec2 p = to_user(problem, position_of(space, point[kX], point[kY]));
  return {p.x, p.y, space.rotation ? radians_of_turns(point[kTheta]) : space.fixed_theta};
}

}  // namespace

CellTable tabulate(const ScaledProblem& problem, const Subdivision& subdivision) {
  const std::size_t count = subdivision.size();
  CellTable table;
  table.lower.reserve(count);
  table.upper.reserve(count);
  table.level.reserve(count);
  table.label.reserve(count);
  for (CellId id = 0; id < count; ++id) {
    const Cell& cell = subdivision.cell(id);
    const CellBox& box = cell.box;
    table.lower.push_back(corner(problem, subdivision.space(), box.low));
    table.upper.push_back(
        corner(problem, subdivision.space(), {box.high(kX), box.high(kY), box.high(kTheta)}));
    table.level.push_back(box.level);
    table.label.push_back(cell.label);
  }
  return table;
}

}  // namespace planner
