#include "max_min.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "tuning.hpp"

namespace planner {

namespace {

// Terms that balance at the optimum: one more than there are variables.
constexpr std::size_t kMost = 4;

// Weights lambda >= 0 of the active terms, their sum 1: d = (sum lambda_i gradient_i) / price, and
// all active terms are equal to `least` there.
struct Active {
  std::array<std::size_t, kMost> term{};
  std::array<double, kMost> weight{};
  std::size_t count = 0;

  [[nodiscard]] bool holds(const std::size_t i) const {
    return std::find(term.begin(), term.begin() + count, i) != term.begin() + count;
  }
  void add(const std::size_t i, const double w) {
    term[count] = i;
    weight[count++] = w;
  }
  void drop(const std::size_t place) {
    --count;
    term[place] = term[count];
    weight[place] = weight[count];
  }
};

using System = std::array<std::array<double, kMost + 2>, kMost + 1>;

// Gauss elimination with row pivots of the first n rows and columns; the last column becomes the
// solution. False if singular.
bool solve(System& rows, const std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    if (rows[pivot][k] == 0.0) return false;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (std::size_t k = 0; k < n; ++k) rows[k][n] /= rows[k][k];
  return true;
}

// The effect of one unit of weight for a new term while the active ones stay equal to each other.
struct Change {
  std::array<double, kMost> weight{};
  Step3 d{};
  double least = 0.0;
};

bool change_for(const std::span<const LinearTerm> terms, const Active& active,
                const std::size_t entering, const double price, Change& change) {
  const std::size_t n = active.count;
  System rows{};
  for (std::size_t i = 0; i < n; ++i) {
    const Step3& g = terms[active.term[i]].gradient;
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(g, terms[active.term[j]].gradient);
    rows[i][n] = -price;
    rows[i][n + 1] = -dot(g, terms[entering].gradient);
    rows[n][i] = 1.0;
  }
  rows[n][n + 1] = -1.0;
  if (!solve(rows, n + 1)) return false;
  change.d = terms[entering].gradient;
  for (std::size_t i = 0; i < n; ++i) {
    change.weight[i] = rows[i][n + 1];
    for (std::size_t k = 0; k < 3; ++k)
      change.d[k] += change.weight[i] * terms[active.term[i]].gradient[k];
  }
  for (double& x : change.d) x /= price;
  change.least = rows[n][n + 1];
  return true;
}

}  // namespace

// Goldfarb and Idnani's dual method: the worst violated term comes in, active ones whose weight
// vanishes on the way go.
MaxMinStep max_min_step(const std::span<const LinearTerm> terms, const double price) {
  const auto value_at = [&](const std::size_t i, const Step3& d) {
    return terms[i].value + dot(terms[i].gradient, d);
  };
  const auto lowest = [&](const Step3& d) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < terms.size(); ++i)
      if (value_at(i, d) < value_at(best, d)) best = i;
    return best;
  };
  Active active;
  active.add(lowest({}), 1.0);
  MaxMinStep step;
  for (std::size_t k = 0; k < 3; ++k) step.d[k] = terms[active.term[0]].gradient[k] / price;
  step.least = value_at(active.term[0], step.d);
  int exchanges = 0;
  for (;;) {
    const std::size_t entering = lowest(step.d);
    if (!(value_at(entering, step.d) < step.least) || active.holds(entering)) break;
    double weight = 0.0;
    for (bool taken = false; !taken;) {
      Change change;
      if (++exchanges > kExchanges || !change_for(terms, active, entering, price, change))
        return {step.d, value_at(lowest(step.d), step.d)};
      const double rate = dot(terms[entering].gradient, change.d) - change.least;
      const double gap = step.least - value_at(entering, step.d);
      const double whole = rate > 0.0 ? gap / rate : std::numeric_limits<double>::infinity();
      double length = whole;
      std::size_t leaving = kMost;
      for (std::size_t i = 0; i < active.count; ++i) {
        if (change.weight[i] >= 0.0) continue;
        const double until = active.weight[i] / -change.weight[i];
        if (until >= length) continue;
        length = until;
        leaving = i;
      }
      if (leaving == kMost && (active.count == kMost || !(length < whole || length == whole)))
        return {step.d, value_at(lowest(step.d), step.d)};
      for (std::size_t i = 0; i < active.count; ++i) active.weight[i] += length * change.weight[i];
      for (std::size_t k = 0; k < 3; ++k) step.d[k] += length * change.d[k];
      step.least += length * change.least;
      weight += length;
      taken = leaving == kMost;
      if (!taken) active.drop(leaving);
    }
    active.add(entering, weight);
  }
  return {step.d, value_at(lowest(step.d), step.d)};
}

}  // namespace planner
