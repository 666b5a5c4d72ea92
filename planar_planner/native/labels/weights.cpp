#include "weights.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tuning.hpp"

namespace planner {

namespace {

constexpr std::size_t kSlacks = 6;

// Slack 2 i counts as p_i, which stands with -1 in row i, slack 2 i + 1 as q_i.
constexpr double slack_sign(const std::size_t slack) {
  return slack % 2 == 0 ? -1.0 : 1.0;
}

}  // namespace

void WeightProgram::remember() {
  remembered_ = basis_;
  any_remembered_ = started_;
}

void WeightProgram::recall() {
  basis_ = remembered_;
  started_ = any_remembered_;
}

void WeightProgram::forget() {
  started_ = any_remembered_ = false;
}

// The single best function, with p or q for each of its components.
void WeightProgram::start() {
  std::size_t first = 0;
  double least = INFINITY;
  for (std::size_t k = 0; k < functions_.size(); ++k) {
    const auto& [g, constant] = functions_[k];
    const double alone = constant + std::abs(g[0]) + std::abs(g[1]) + std::abs(g[2]);
    if (alone < least) {
      least = alone;
      first = k;
    }
  }
  basis_ = {};
  basis_.columns[3] = kSlacks + first;
  basis_.costs[3] = functions_[first].constant;
  basis_.inverse[3][3] = 1.0;
  basis_.solution[3] = 1.0;
  for (std::size_t row = 0; row < 3; ++row) {
    const double g = functions_[first].gradient[row];
    const double sign = g >= 0.0 ? -1.0 : 1.0;  // p - q = g, written as g - p + q = 0
    basis_.columns[row] = 2 * row + (sign > 0.0 ? 1 : 0);
    basis_.costs[row] = 1.0;
    basis_.inverse[row][row] = sign;
    basis_.inverse[row][3] = -sign * g;
    basis_.solution[row] = std::abs(g);
  }
  started_ = true;
}

std::optional<WeightProgram::Weights> WeightProgram::solve() {
  if (functions_.empty() || !reach_negative_sum()) return std::nullopt;
  return weights();
}

bool WeightProgram::reach_negative_sum() {
  if (!started_) start();
  for (int pivots = 0; pivots <= kPivots; ++pivots) {
    double value = 0.0;
    Column prices{};
    for (std::size_t i = 0; i < kRows; ++i) {
      value += basis_.costs[i] * basis_.solution[i];
      for (std::size_t j = 0; j < kRows; ++j) prices[j] += basis_.costs[i] * basis_.inverse[i][j];
    }
    if (value < 0.0) return true;
    std::size_t entering = SIZE_MAX;
    double steepest = 0.0;
    for (std::size_t slack = 0; slack < kSlacks; ++slack) {
      const double reduced = 1.0 - slack_sign(slack) * prices[slack / 2];
      if (reduced < steepest) {
        steepest = reduced;
        entering = slack;
      }
    }
    const bool inside = entering == SIZE_MAX;  // z = -prices is in the cube
    double least = 0.0;
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      const auto& [g, constant] = functions_[k];
      const double reduced =
          constant - prices[0] * g[0] - prices[1] * g[1] - prices[2] * g[2] - prices[3];
      least = std::min(least, reduced);
      if (reduced < steepest) {
        steepest = reduced;
        entering = kSlacks + k;
      }
    }
    // No function is below prices[3] + least at z.
    if (inside && prices[3] + least >= 0.0) return false;
    if (entering == SIZE_MAX || !pivot(entering)) return false;
  }
  return false;
}

bool WeightProgram::pivot(const std::size_t entering) {
  Column direction{};
  if (entering < kSlacks) {
    const double sign = slack_sign(entering);
    for (std::size_t i = 0; i < kRows; ++i) direction[i] = sign * basis_.inverse[i][entering / 2];
  } else {
    const Gradient& g = functions_[entering - kSlacks].gradient;
    for (std::size_t i = 0; i < kRows; ++i) {
      const Column& row = basis_.inverse[i];
      direction[i] = row[0] * g[0] + row[1] * g[1] + row[2] * g[2] + row[3];
    }
  }
  std::size_t leaving = kRows;
  double step = INFINITY;
  for (std::size_t i = 0; i < kRows; ++i)
    if (direction[i] > 0.0 && basis_.solution[i] < step * direction[i]) {
      step = basis_.solution[i] / direction[i];
      leaving = i;
    }
  if (leaving == kRows) return false;
  const double scale = 1.0 / direction[leaving];
  for (std::size_t i = 0; i < kRows; ++i) {
    if (i == leaving) continue;
    const double factor = direction[i] * scale;
    basis_.solution[i] -= factor * basis_.solution[leaving];
    for (std::size_t j = 0; j < kRows; ++j)
      basis_.inverse[i][j] -= factor * basis_.inverse[leaving][j];
  }
  basis_.solution[leaving] *= scale;
  for (double& x : basis_.inverse[leaving]) x *= scale;
  basis_.columns[leaving] = entering;
  basis_.costs[leaving] = entering < kSlacks ? 1.0 : functions_[entering - kSlacks].constant;
  return true;
}

WeightProgram::Weights WeightProgram::weights() const {
  Weights out;
  for (std::size_t i = 0; i < kRows; ++i)
    if (basis_.columns[i] >= kSlacks && basis_.solution[i] > 0.0)
      out.items[out.count++] = {basis_.columns[i] - kSlacks, basis_.solution[i]};
  return out;
}

}  // namespace planner
