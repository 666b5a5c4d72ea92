// Weights of functions f_k(z) = c_k + g_k . z, |z_i| <= 1, whose weighted sum is negative in the
// whole cube. They minimise
//     sum lambda_k c_k + |sum lambda_k g_k|_1  over  lambda >= 0, sum lambda = 1,
// which by duality is the largest value that min_k f_k takes in the cube. A primal simplex method
// with a basis of four, stopped as soon as the sign is known. Plain doubles: a proof has to look at
// the weights again.
#pragma once

#include <array>
#include <cstddef>
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

  // Drops all functions but the first `count`. Only if they alone are those of the remembered basis
  // or none is remembered.
  void keep(const std::size_t count) { functions_.resize(count); }

  // Can the functions be weighted like that? False also when the pivots run out.
  bool solve();
  // After solve() was true.
  [[nodiscard]] Weights weights() const;

  // More functions are often added to the same ones: solve() goes on from the remembered basis.
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
  bool pivot(std::size_t entering);

  std::vector<Function> functions_;
  Basis basis_, remembered_;
  bool started_ = false, any_remembered_ = false;
};

}  // namespace planner
