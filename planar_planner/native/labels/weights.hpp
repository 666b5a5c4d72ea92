// Weights of functions f_k(z) = c_k + g_k . z, |z_i| <= 1, whose weighted sum is negative in the
// whole cube. They minimise
//     sum lambda_k c_k + |sum lambda_k g_k|_1  over  lambda >= 0, sum lambda = 1,
// which by duality is the largest value that min_k f_k takes in the cube. A primal simplex method
// with a basis of four, stopped as soon as the sign is known. Plain doubles: a proof has to look at
// the weights again.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace planner {

using Gradient = std::array<double, 3>;

class WeightProgram {
 public:
  struct Function {
    Gradient gradient;
    double constant;
  };
  // At most four functions have a weight; the rest of the array is not used.
  struct Weight {
    std::size_t function;
    double value;
  };
  struct Weights {
    std::array<Weight, 4> items{};
    std::size_t count = 0;
  };

  void clear() {
    keep(0);
    started_ = false;
  }
  void add(const Function& function) { functions_.push_back(function); }
  [[nodiscard]] const Function& function(const std::size_t k) const { return functions_[k]; }

  // Drops all functions but the first `count`. A remembered basis must not use any that is dropped.
  void keep(const std::size_t count) { functions_.resize(count); }

  // Weights with a negative sum; empty if there are none, or when the pivots run out. Starts from
  // the basis that the last call ended with, if there was one.
  std::optional<Weights> solve();

  // For functions that are added to the same ones again and again: remember() keeps the present
  // basis, recall() makes it present again, forget() lets the next solve() start anew.
  void remember();
  void recall();
  void forget();

 private:
  static constexpr std::size_t kRows = 4;  // three components of the gradients, and the sum
  using Column = std::array<double, kRows>;
  // Columns: six slacks p_0, q_0, p_1, ... of  sum lambda_k g_k = p - q, then the functions.
  struct Basis {
    std::array<std::size_t, kRows> columns{};
    std::array<double, kRows> costs{};
    std::array<Column, kRows> inverse{};
    Column solution{};
  };

  void start();
  bool reach_negative_sum();
  [[nodiscard]] Weights weights() const;
  bool pivot(std::size_t entering);

  std::vector<Function> functions_;
  Basis basis_, remembered_;
  bool started_ = false, any_remembered_ = false;
};

}  // namespace planner
