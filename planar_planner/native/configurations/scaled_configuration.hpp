// Configurations in planner units, and the way to the user's doubles and back: what is certified is
// what is returned.
#pragma once

#include <array>
#include <cstdint>

#include "planar_planner/native/world/problem.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// Planner units; theta in radians, unwrapped.
struct ScaledConfiguration {
  Vec2 t;
  double theta = 0.0;
};

ScaledConfiguration scaled(const ScaledProblem& problem, const Configuration& q);
// Moved onto the reference bounds where rounding carried it out of them.
Configuration configuration_of(const ScaledProblem& problem, const ScaledConfiguration& q);

// Its place in the domain in units of 2^-60 (dyadic_box.hpp), up to kDyadicSlack.
std::array<std::uint64_t, 3> dyadic_point(const ScaledProblem& problem, const Configuration& q);

// Units of 2^-60 of the domain and of a turn: x and y are rounded 5 times at magnitudes below 2
// domain widths (10 u), theta by sine, cosine, arc tangent and a division (6 u of a turn), and the
// result is cut off to a unit; 16 u = 2^11 units, doubled.
inline constexpr std::uint64_t kDyadicSlack = std::uint64_t{1} << 12U;

}  // namespace planner
