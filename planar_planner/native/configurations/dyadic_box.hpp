// Cells of the (x, y, theta) domain as exact dyadic boxes; theta in turns, so that wrapping is
// exact. Coordinates count 2^-60 of the domain's width, height and of a turn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

inline constexpr unsigned kCoordinateBits = 60;
inline constexpr std::uint64_t kUnit = std::uint64_t{1} << kCoordinateBits;
// Deepest split of one axis: centres of cells stay exact doubles (level + 1 <= 53).
inline constexpr int kMaxLevel = 50;

using Axis = std::size_t;
inline constexpr Axis kX = 0;
inline constexpr Axis kY = 1;
inline constexpr Axis kTheta = 2;
inline constexpr Axis kNoAxis = 3;

struct CellBox {
  std::array<std::uint64_t, 3> low{};
  std::array<std::uint8_t, 3> level{};

  [[nodiscard]] std::uint64_t size(const Axis axis) const { return kUnit >> level[axis]; }
  [[nodiscard]] std::uint64_t high(const Axis axis) const { return low[axis] + size(axis); }
};

struct Halves {
  CellBox lower, upper;
};
Halves halve(const CellBox& box, Axis axis);

// The closed boxes share a face of positive area; `axis` is its normal.
bool adjacent(const CellBox& a, const CellBox& b, Axis& axis);

// A face or a cell as exact extents: axes with size 0 are flat.
struct Extent {
  std::array<std::uint64_t, 3> low{};
  std::array<std::uint64_t, 3> size{};
};
Extent extent_of(const CellBox& box);
// The common face of two adjacent boxes with normal `axis`.
Extent common_face(const CellBox& a, const CellBox& b, Axis axis);

// cos and sin of 2 pi k 2^-60, reduced exactly to an eighth of a turn: error below 3 u.
pdg::Rotation rotation_of_turns(std::uint64_t turns);

// Radians of k 2^-60 turns.
double radians_of_turns(std::uint64_t turns);

// What the planner works on besides the domain: with `rotation` false, theta is one fixed angle.
struct CellSpace {
  Domain domain;
  bool rotation = true;
  double fixed_theta = 0.0;
};

pdg::Motion motion_of(const CellSpace& space, const Extent& extent);
pdg::Rotation rotation_of(const CellSpace& space, const Extent& extent);

// Planner-unit coordinates of a dyadic point.
Vec2 position_of(const CellSpace& space, std::uint64_t x, std::uint64_t y);

}  // namespace planner
