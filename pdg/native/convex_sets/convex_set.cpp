#include "convex_set.hpp"

#include <stdexcept>
#include <utility>

#include "pdg/native/tolerances.hpp"

namespace pdg {

ConvexSet::ConvexSet(std::vector<double> magnitude, std::vector<double> error)
    : magnitude_(std::move(magnitude)), error_(std::move(error)) {
  if (magnitude_.empty() || magnitude_.size() != error_.size()) {
    throw std::invalid_argument("a convex set needs one magnitude and one error per coordinate");
  }
}

std::vector<double> rounding_error(const std::span<const double> magnitude,
                                   const std::size_t terms) {
  std::vector<double> error;
  error.reserve(magnitude.size());
  for (const double m : magnitude) {
    error.push_back((2.0 * static_cast<double>(terms) + kSupportErrorUnits) * kUnitRoundoff * m);
  }
  return error;
}

}  // namespace pdg
