// What the harness counts of one family of predicates.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "truth/ball.hpp"

namespace rounding {

struct Tally {
  std::string family;
  std::uint64_t inputs = 0;      // predicates evaluated
  std::uint64_t claims = 0;      // of these, labels that say something
  std::uint64_t false_ones = 0;  // claims that the exact side could not confirm
  std::uint64_t values = 0;      // computed values held against exact ones
  double tightness = 0.0;        // largest error on the unsafe side over its bound
  bool leans_on_margin = true;   // without the margins there must be false claims

  // A claim, and whether the exact side confirms it beyond doubt.
  void claim(const bool confirmed) {
    ++claims;
    if (!confirmed) ++false_ones;
  }
  // A value that must not exceed the exact one by more than the bound.
  void not_above(const double computed, const exact::Ball& truth, const double bound) {
    ++values;
    const exact::Ball error = exact::Ball(computed) - truth;
    const double ratio = (error.value() + error.radius) / bound;
    if (!(ratio <= tightness)) tightness = ratio;  // a NaN shows
  }
  void not_below(const double computed, const exact::Ball& truth, const double bound) {
    not_above(-computed, -truth, bound);
  }
  void near(const double computed, const exact::Ball& truth, const double bound) {
    not_above(computed, truth, bound);
    not_below(computed, truth, bound);
  }
};

struct Request {
  std::uint64_t inputs = 0;
  std::uint64_t seed = 0;
  bool adversarial = false;
};

}  // namespace rounding
