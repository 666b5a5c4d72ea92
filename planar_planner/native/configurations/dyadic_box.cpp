#include "dyadic_box.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "pdg/native/tolerances.hpp"
#include "quarter_turn.hpp"

namespace planner {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Exact for what fits 53 bits, rounded once otherwise.
double fraction(const std::uint64_t k) {
  return static_cast<double>(k) * 0x1p-60;
}
static_assert(kCoordinateBits == 60);

using pdg::HalfAngle;

// cos and sin of half a cell's angle, by its size as a power of two of a turn. Sizes are powers of
// two, so there are few of them; theta sizes above half a turn do not occur.
HalfAngle half_angle(const std::uint64_t size) {
  static const auto table = [] {
    std::array<HalfAngle, kCoordinateBits + 1> t{};
    for (std::size_t bit = 0; bit <= kCoordinateBits; ++bit) {
      const double angle = kTurn * 0.5 * fraction(std::uint64_t{1} << bit);
      t[bit] = pdg::half_angle_of(angle);
    }
    t[kCoordinateBits - 1] = {std::numbers::pi / 2, 0.0, 1.0};
    return t;
  }();
  if (size == 0) return {};
  return table[static_cast<std::size_t>(std::bit_width(size)) - 1];
}

}  // namespace

Halves halve(const CellBox& box, const Axis axis) {
  Halves out{box, box};
  ++out.lower.level[axis];
  ++out.upper.level[axis];
  out.upper.low[axis] += out.upper.size(axis);
  return out;
}

bool adjacent(const CellBox& a, const CellBox& b, Axis& axis) {
  Axis touching = kNoAxis;
  for (Axis k = 0; k < kNoAxis; ++k) {
    if (a.low[k] < b.high(k) && b.low[k] < a.high(k)) continue;  // overlap in the interior
    bool abut = a.high(k) == b.low[k] || b.high(k) == a.low[k];
    if (k == kTheta)
      abut = abut || (a.high(k) == kUnit && b.low[k] == 0) || (b.high(k) == kUnit && a.low[k] == 0);
    if (!abut || touching != kNoAxis) return false;
    touching = k;
  }
  axis = touching;
  return touching != kNoAxis;
}

Extent extent_of(const CellBox& box) {
  return {box.low, {box.size(0), box.size(1), box.size(2)}};
}

Extent common_face(const CellBox& a, const CellBox& b, const Axis axis) {
  Extent face;
  for (Axis k = 0; k < kNoAxis; ++k) {
    face.low[k] = std::max(a.low[k], b.low[k]);
    face.size[k] = std::min(a.high(k), b.high(k)) - face.low[k];
  }
  face.size[axis] = 0;
  // Cells span at most a quarter turn, so two of them touch on one side only.
  const bool a_first =
      a.high(axis) == b.low[axis] || (axis == kTheta && a.high(axis) == kUnit && b.low[axis] == 0);
  face.low[axis] = a_first ? b.low[axis] : a.low[axis];
  return face;
}

double radians_of_turns(const std::uint64_t turns) {
  return kTurn * fraction(turns);
}

pdg::Rotation rotation_of_turns(const std::uint64_t turns) {
  constexpr std::uint64_t quarter = kUnit / 4;
  const std::uint64_t nearest = (turns + quarter / 2) / quarter;
  const double rest = turns >= nearest * quarter ? fraction(turns - nearest * quarter)
                                                 : -fraction(nearest * quarter - turns);
  const double c = std::cos(kTurn * rest);
  const double s = std::sin(kTurn * rest);
  switch (nearest % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

pdg::Rotation rotation_of(const CellSpace& space, const Extent& e) {
  if (!space.rotation) return rotation_at(space.fixed_theta);
  return rotation_of_turns(e.low[kTheta] + e.size[kTheta] / 2);
}

Vec2 position_of(const CellSpace& space, const std::uint64_t x, const std::uint64_t y) {
  return {space.domain.low.x + space.domain.size.x * fraction(x),
          space.domain.low.y + space.domain.size.y * fraction(y)};
}

pdg::Motion motion_of(const CellSpace& space, const Extent& e) {
  const Vec2 centre = position_of(space, e.low[kX] + e.size[kX] / 2, e.low[kY] + e.size[kY] / 2);
  const Vec2 half{0.5 * space.domain.size.x * fraction(e.size[kX]),
                  0.5 * space.domain.size.y * fraction(e.size[kY])};
  return pdg::make_motion(centre, {half.x, 0.0}, {0.0, half.y},
                          space.rotation ? half_angle(e.size[kTheta]) : HalfAngle{},
                          space.domain.reach);
}

}  // namespace planner
