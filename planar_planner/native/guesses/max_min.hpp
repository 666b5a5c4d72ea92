// The step that raises the least of some linear functions of three variables the most, a quadratic
// price on its length: a proximal step of non-smooth optimisation. Plain doubles; a hint.
#pragma once

#include <array>
#include <span>

namespace planner {

using Step3 = std::array<double, 3>;

// value + gradient . d
struct LinearTerm {
  double value;
  Step3 gradient;
};

constexpr double dot(const Step3& a, const Step3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct MaxMinStep {
  Step3 d{};
  double least = 0.0;  // of the functions at d
};

// The d that maximises  min_i (value_i + gradient_i . d) - price / 2 |d|^2. At least one term.
// Where terms oppose each other it goes all the way to where they balance, and no farther along
// directions that none of them minds; |d| <= max |gradient| / price.
MaxMinStep max_min_step(std::span<const LinearTerm> terms, double price);

}  // namespace planner
