#include "convex_composites.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "pdg/native/tolerances.hpp"
#include "vectors.hpp"

namespace pdg {
namespace {

using View = std::span<const double>;

// The common dimension.
std::size_t checked_dimension(const std::vector<SetPointer>& sets) {
  if (sets.empty()) throw std::invalid_argument("at least one set is needed");
  for (const SetPointer& set : sets) {
    if (set->dimension() != sets.front()->dimension()) {
      throw std::invalid_argument("the sets must have one dimension");
    }
  }
  return sets.front()->dimension();
}

std::vector<double> sum_of_magnitudes(const std::vector<SetPointer>& sets) {
  std::vector<double> sum(checked_dimension(sets));
  for (const SetPointer& set : sets) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += set->magnitude()[i];
  }
  return sum;
}

// The summands' errors and the rounding of the summation.
std::vector<double> sum_of_errors(const std::vector<SetPointer>& sets) {
  std::vector<double> error = rounding_error(sum_of_magnitudes(sets), sets.size());
  for (const SetPointer& set : sets) {
    for (std::size_t i = 0; i < error.size(); ++i) error[i] += set->error()[i];
  }
  return error;
}

class MinkowskiSum final : public ConvexSet {
 public:
  explicit MinkowskiSum(std::vector<SetPointer> sets)
      : ConvexSet(sum_of_magnitudes(sets), sum_of_errors(sets)), sets_(std::move(sets)) {}

  [[nodiscard]] double value(const View u) const override {
    double sum = 0.0;
    for (const SetPointer& set : sets_) sum += set->value(u);
    return sum;
  }

  double add_support(const View u, const std::span<double> point) const override {
    // Each summand apart: one that is a sum itself rounds at its own magnitude, not at ours.
    Scratch summand(u.size());
    double sum = 0.0;
    for (const SetPointer& set : sets_) {
      sum += support(*set, u, summand.span());
      for (std::size_t i = 0; i < u.size(); ++i) point[i] += summand.span()[i];
    }
    return sum;
  }

 private:
  std::vector<SetPointer> sets_;
};

template <class Get>
std::vector<double> largest(const std::vector<SetPointer>& sets, const Get& get) {
  std::vector<double> result(checked_dimension(sets));
  for (const SetPointer& set : sets) {
    const View numbers = get(*set);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::max(result[i], numbers[i]);
  }
  return result;
}

class UnionHull final : public ConvexSet {
 public:
  explicit UnionHull(std::vector<SetPointer> sets)
      : ConvexSet(largest(sets, [](const ConvexSet& set) { return set.magnitude(); }),
                  largest(sets, [](const ConvexSet& set) { return set.error(); })),
        sets_(std::move(sets)) {}

  [[nodiscard]] double value(const View u) const override { return best(u).second; }

  double add_support(const View u, const std::span<double> point) const override {
    return best(u).first->add_support(u, point);
  }

 private:
  [[nodiscard]] std::pair<const ConvexSet*, double> best(const View u) const {
    std::pair<const ConvexSet*, double> found{sets_.front().get(), sets_.front()->value(u)};
    for (std::size_t k = 1; k < sets_.size(); ++k) {
      const double value = sets_[k]->value(u);
      if (value > found.second) found = {sets_[k].get(), value};
    }
    return found;
  }

  std::vector<SetPointer> sets_;
};

void check_map(const Matrix& map, const View offset, const ConvexSet& set) {
  if (map.rows != offset.size() || map.columns != set.dimension() ||
      map.entries.size() != map.rows * map.columns) {
    throw std::invalid_argument("the map does not fit the set and the offset");
  }
}

std::vector<double> image_magnitude(const Matrix& map, const View offset, const ConvexSet& set) {
  check_map(map, offset, set);
  std::vector<double> magnitude(map.rows);
  for (std::size_t i = 0; i < map.rows; ++i) {
    magnitude[i] = std::abs(offset[i]);
    for (std::size_t j = 0; j < map.columns; ++j) {
      magnitude[i] += std::abs(map.row(i)[j]) * set.magnitude()[j];
    }
  }
  return magnitude;
}

// The images of the set's errors, and the rounding of both products, M^T u and M s.
std::vector<double> image_error(const Matrix& map, const View offset, const ConvexSet& set) {
  std::vector<double> error =
      rounding_error(image_magnitude(map, offset, set), map.rows + map.columns);
  for (std::size_t i = 0; i < map.rows; ++i) {
    for (std::size_t j = 0; j < map.columns; ++j) {
      error[i] += std::abs(map.row(i)[j]) * set.error()[j];
    }
  }
  return error;
}

class AffineImage final : public ConvexSet {
 public:
  AffineImage(Matrix map, std::vector<double> offset, SetPointer set)
      : ConvexSet(image_magnitude(map, offset, *set), image_error(map, offset, *set)),
        map_(std::move(map)),
        offset_(std::move(offset)),
        set_(std::move(set)) {}

  [[nodiscard]] double value(const View u) const override {
    Scratch scratch(map_.columns);
    pull_back(u, scratch.span());
    return set_->value(scratch.span()) + dot(offset_, u);
  }

  double add_support(const View u, const std::span<double> point) const override {
    Scratch direction(map_.columns);
    Scratch inner(map_.columns);
    pull_back(u, direction.span());
    const double value = set_->add_support(direction.span(), inner.span());
    for (std::size_t i = 0; i < map_.rows; ++i) {
      point[i] += dot(map_.row(i), inner.span()) + offset_[i];
    }
    return value + dot(offset_, u);
  }

 private:
  // w = M^T u.
  void pull_back(const View u, const std::span<double> w) const {
    for (std::size_t i = 0; i < map_.rows; ++i) {
      const View row = map_.row(i);
      for (std::size_t j = 0; j < map_.columns; ++j) w[j] += row[j] * u[i];
    }
  }

  Matrix map_;
  std::vector<double> offset_;
  SetPointer set_;
};

std::vector<double> stretched_bounds(const View factors, const View bounds) {
  if (factors.size() != bounds.size()) {
    throw std::invalid_argument("one factor per coordinate is needed");
  }
  std::vector<double> result;
  result.reserve(factors.size());
  for (std::size_t i = 0; i < factors.size(); ++i) {
    result.push_back(std::abs(factors[i]) * bounds[i]);
  }
  return result;
}

bool is_power_of_two(const double x) {
  int exponent = 0;
  return std::abs(std::frexp(x, &exponent)) == 0.5;
}

std::vector<double> stretched_error(const View factors, const ConvexSet& set) {
  std::vector<double> error = stretched_bounds(factors, set.error());
  if (!std::ranges::all_of(factors, is_power_of_two)) {
    const std::vector<double> rounding =
        rounding_error(stretched_bounds(factors, set.magnitude()), 1);
    for (std::size_t i = 0; i < error.size(); ++i) error[i] += rounding[i];
  }
  return error;
}

class Stretched final : public ConvexSet {
 public:
  Stretched(std::vector<double> factors, SetPointer set)
      : ConvexSet(stretched_bounds(factors, set->magnitude()), stretched_error(factors, *set)),
        factors_(std::move(factors)),
        set_(std::move(set)) {}

  [[nodiscard]] double value(const View u) const override {
    Scratch direction(u.size());
    return set_->value(pulled_back(u, direction.span()));
  }

  double add_support(const View u, const std::span<double> point) const override {
    Scratch direction(u.size());
    Scratch inner(u.size());
    const double value = set_->add_support(pulled_back(u, direction.span()), inner.span());
    for (std::size_t i = 0; i < u.size(); ++i) point[i] += factors_[i] * inner.span()[i];
    return value;
  }

 private:
  View pulled_back(const View u, const std::span<double> w) const {
    for (std::size_t i = 0; i < u.size(); ++i) w[i] = factors_[i] * u[i];
    return w;
  }

  std::vector<double> factors_;
  SetPointer set_;
};

}  // namespace

SetPointer minkowski_sum(std::vector<SetPointer> sets) {
  return std::make_shared<MinkowskiSum>(std::move(sets));
}

SetPointer union_hull(std::vector<SetPointer> sets) {
  return std::make_shared<UnionHull>(std::move(sets));
}

SetPointer affine_image(Matrix map, std::vector<double> offset, SetPointer set) {
  return std::make_shared<AffineImage>(std::move(map), std::move(offset), std::move(set));
}

SetPointer stretched(std::vector<double> factors, SetPointer set) {
  return std::make_shared<Stretched>(std::move(factors), std::move(set));
}

SetPointer scaled(const double factor, SetPointer set) {
  std::vector<double> factors(set->dimension(), factor);
  return stretched(std::move(factors), std::move(set));
}

}  // namespace pdg
