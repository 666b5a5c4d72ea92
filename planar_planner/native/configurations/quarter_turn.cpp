#include "quarter_turn.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace planner {

namespace {

// pi/2 to twice the precision of a double.
constexpr double kHalfPi = std::numbers::pi / 2;
constexpr double kHalfPiRest = 0x1.1a62633145c07p-54;

}  // namespace

double radians_of_quarters(const std::int64_t quarters) {
  const auto k = static_cast<double>(quarters);
  const double product = k * kHalfPi;
  const double rest = std::fma(k, kHalfPi, -product) + k * kHalfPiRest;
  return product + rest;
}

std::optional<std::int64_t> quarters_of(const double theta) {
  const auto nearest = static_cast<std::int64_t>(std::floor(theta / kHalfPi + 0.5));
  if (radians_of_quarters(nearest) != theta) return std::nullopt;
  return nearest;
}

pdg::Rotation rotation_at(const double theta) {
  constexpr std::array<pdg::Rotation, 4> exact = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  if (const auto quarters = quarters_of(theta))
    return exact[static_cast<std::size_t>(within_turn(*quarters))];
  return {std::cos(theta), std::sin(theta)};
}

double nearest_turn(const double angle, const double theta) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double turns = std::round((theta - angle) / turn);
  if (const auto quarters = quarters_of(angle))
    return radians_of_quarters(*quarters + 4 * static_cast<std::int64_t>(turns));
  return angle + turn * turns;
}

}  // namespace planner
