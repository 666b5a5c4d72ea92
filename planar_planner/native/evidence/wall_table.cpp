#include "wall_table.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace planner {

namespace {

// Without rotation theta has no extent of its own: a claim is for all of it.
Extent whole_turn(const ScaledProblem& problem, Extent box) {
  if (problem.rotation) return box;
  box.low[kTheta] = 0;
  box.size[kTheta] = kUnit;
  return box;
}

// The domain's corner is rounded before the box's offset is added to it, as whoever reads the
// certificate does: both then have the same doubles.
std::array<double, 3> corner(const ScaledProblem& problem,
                             const std::array<std::uint64_t, 3>& point) {
  const Vec2 low = to_user(problem, problem.domain.low);
  const auto along = [&](const double from, const double size, const std::uint64_t k) {
    return from + length_to_user(problem, size) *
                      std::ldexp(static_cast<double>(k), -static_cast<int>(kCoordinateBits));
  };
  return {along(low.x, problem.domain.size.x, point[kX]),
          along(low.y, problem.domain.size.y, point[kY]), radians_of_turns(point[kTheta])};
}

// How often an axis was halved to get an interval of this size, or a plane at this place.
std::uint8_t halvings(const Extent& box, const Axis axis) {
  const std::uint64_t multiple = box.size[axis] == 0 ? box.low[axis] | kUnit : box.size[axis];
  const int zeros = std::countr_zero(multiple);
  return static_cast<std::uint8_t>(static_cast<int>(kCoordinateBits) - zeros);
}

void append(CellTable& table, const ScaledProblem& problem, const FullClaim& claim) {
  const Extent box = whole_turn(problem, claim.box);
  std::array<std::uint64_t, 3> high{};
  for (Axis axis = 0; axis < kNoAxis; ++axis) high[axis] = box.low[axis] + box.size[axis];
  table.lower.push_back(corner(problem, box.low));
  table.upper.push_back(corner(problem, high));
  table.level.push_back({halvings(box, kX), halvings(box, kY), halvings(box, kTheta)});
  table.label.push_back(Label::kFull);
}

}  // namespace

CellTable tabulate(const ScaledProblem& problem, const Barrier& barrier) {
  CellTable table;
  for (const std::vector<FullClaim>* claims : {&barrier.cells, &barrier.faces})
    for (const FullClaim& claim : *claims) append(table, problem, claim);
  return table;
}

}  // namespace planner
