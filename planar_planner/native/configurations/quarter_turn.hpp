// Quarter turns, whose sine and cosine are exact. No double but 0 is a multiple of pi/2; the double
// that is nearest to one means it.
#pragma once

#include <cstdint>
#include <optional>

#include "pdg/native/geometry/motion.hpp"

namespace planner {

// How many quarter turns theta means; empty if it means another angle. |theta| < 2^21.
std::optional<std::int64_t> quarters_of(double theta);
// The double nearest to so many quarter turns; |quarters| < 2^21.
double radians_of_quarters(std::int64_t quarters);
// 0 to 3.
constexpr int within_turn(const std::int64_t quarters) {
  return static_cast<int>(((quarters % 4) + 4) % 4);
}

// Cosine and sine of what theta means: exact for quarter turns.
pdg::Rotation rotation_at(double theta);

// `angle` plus the whole turns that bring it nearest to `theta`; quarter turns stay exact.
double nearest_turn(double angle, double theta);

}  // namespace planner
