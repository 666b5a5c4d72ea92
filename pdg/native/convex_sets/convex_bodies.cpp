#include "convex_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "vectors.hpp"

namespace pdg {
namespace {

using View = std::span<const double>;

std::vector<double> reach(const View centre, const View extents) {
  if (centre.size() != extents.size()) {
    throw std::invalid_argument("centre and extents must have one number per coordinate");
  }
  std::vector<double> magnitude;
  magnitude.reserve(centre.size());
  for (std::size_t i = 0; i < centre.size(); ++i) {
    magnitude.push_back(std::abs(centre[i]) + std::abs(extents[i]));
  }
  return magnitude;
}

// A set given by a centre and one extent per coordinate.
class Centred : public ConvexSet {
 public:
  Centred(std::vector<double> extents, std::vector<double> centre)
      : ConvexSet(reach(centre, extents), rounding_error(reach(centre, extents), centre.size())),
        r(std::move(extents)),
        c(std::move(centre)) {}

 protected:
  std::vector<double> r;
  std::vector<double> c;
};

class AxisEllipsoid final : public Centred {
 public:
  using Centred::Centred;

  [[nodiscard]] double value(const View u) const override { return dot(c, u) + radius(u); }

  double add_support(const View u, const std::span<double> point) const override {
    const double rho = radius(u);
    const double divisor = rho > 0.0 ? rho : 1.0;
    for (std::size_t i = 0; i < c.size(); ++i) point[i] += c[i] + r[i] * (r[i] * u[i] / divisor);
    return dot(c, u) + rho;
  }

 private:
  [[nodiscard]] double radius(const View u) const {
    double square = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) square += (r[i] * u[i]) * (r[i] * u[i]);
    return std::sqrt(square);
  }
};

class Box final : public Centred {
 public:
  using Centred::Centred;

  [[nodiscard]] double value(const View u) const override {
    double extent = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) extent += r[i] * std::abs(u[i]);
    return dot(c, u) + extent;
  }

  double add_support(const View u, const std::span<double> point) const override {
    for (std::size_t i = 0; i < c.size(); ++i) point[i] += u[i] < 0.0 ? c[i] - r[i] : c[i] + r[i];
    return value(u);
  }
};

class CrossPolytope final : public Centred {
 public:
  using Centred::Centred;

  [[nodiscard]] double value(const View u) const override {
    const std::size_t i = tip(u);
    return dot(c, u) + r[i] * std::abs(u[i]);
  }

  double add_support(const View u, const std::span<double> point) const override {
    const std::size_t tip_axis = tip(u);
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double offset = i == tip_axis ? std::copysign(r[i], u[i]) : 0.0;
      point[i] += c[i] + offset;
    }
    return dot(c, u) + r[tip_axis] * std::abs(u[tip_axis]);
  }

 private:
  [[nodiscard]] std::size_t tip(const View u) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < c.size(); ++i) {
      if (r[i] * std::abs(u[i]) > r[best] * std::abs(u[best])) best = i;
    }
    return best;
  }
};

std::vector<double> row_sums(const Matrix& m, const View centre) {
  if (m.rows != centre.size() || m.entries.size() != m.rows * m.columns) {
    throw std::invalid_argument("an ellipsoid needs one row of axes per coordinate of its centre");
  }
  std::vector<double> sums(centre.size());
  for (std::size_t i = 0; i < m.rows; ++i) {
    sums[i] = std::abs(centre[i]);
    for (const double entry : m.row(i)) sums[i] += std::abs(entry);
  }
  return sums;
}

class Ellipsoid final : public ConvexSet {
 public:
  Ellipsoid(Matrix axes, std::vector<double> centre)
      : ConvexSet(row_sums(axes, centre),
                  rounding_error(row_sums(axes, centre), axes.rows + axes.columns)),
        m_(std::move(axes)),
        c_(std::move(centre)) {}

  [[nodiscard]] double value(const View u) const override {
    Scratch scratch(m_.columns);
    return dot(c_, u) + image(u, scratch.span());
  }

  double add_support(const View u, const std::span<double> point) const override {
    Scratch scratch(m_.columns);
    const std::span<double> w = scratch.span();
    const double rho = image(u, w);
    const double divisor = rho > 0.0 ? rho : 1.0;
    for (double& x : w) x /= divisor;
    for (std::size_t i = 0; i < c_.size(); ++i) point[i] += c_[i] + dot(m_.row(i), w);
    return dot(c_, u) + rho;
  }

 private:
  // w = M^T u; returns |w|.
  double image(const View u, const std::span<double> w) const {
    for (std::size_t i = 0; i < m_.rows; ++i) {
      const View row = m_.row(i);
      for (std::size_t j = 0; j < m_.columns; ++j) w[j] += row[j] * u[i];
    }
    return std::sqrt(dot(w, w));
  }

  Matrix m_;
  std::vector<double> c_;
};

std::vector<double> largest_in_columns(const Matrix& points) {
  if (points.rows == 0 || points.entries.size() != points.rows * points.columns) {
    throw std::invalid_argument("a point set needs at least one point");
  }
  std::vector<double> largest(points.columns);
  for (std::size_t k = 0; k < points.rows; ++k) {
    for (std::size_t i = 0; i < points.columns; ++i) {
      largest[i] = std::max(largest[i], std::abs(points.row(k)[i]));
    }
  }
  return largest;
}

class PointSet final : public ConvexSet {
 public:
  explicit PointSet(Matrix points)
      : ConvexSet(largest_in_columns(points),
                  rounding_error(largest_in_columns(points), points.columns)),
        points_(std::move(points)) {}

  [[nodiscard]] double value(const View u) const override { return best(u).value; }

  double add_support(const View u, const std::span<double> point) const override {
    const Best found = best(u);
    const View p = points_.row(found.row);
    for (std::size_t i = 0; i < p.size(); ++i) point[i] += p[i];
    return found.value;
  }

 private:
  struct Best {
    std::size_t row = 0;
    double value = 0.0;
  };

  [[nodiscard]] Best best(const View u) const {
    Best found{0, dot(points_.row(0), u)};
    for (std::size_t k = 1; k < points_.rows; ++k) {
      const double value = dot(points_.row(k), u);
      if (value > found.value) found = {k, value};
    }
    return found;
  }

  Matrix points_;
};

}  // namespace

SetPointer axis_ellipsoid(std::vector<double> radii, std::vector<double> centre) {
  return std::make_shared<AxisEllipsoid>(std::move(radii), std::move(centre));
}

SetPointer ellipsoid(Matrix axes, std::vector<double> centre) {
  return std::make_shared<Ellipsoid>(std::move(axes), std::move(centre));
}

SetPointer box(std::vector<double> half_extents, std::vector<double> centre) {
  return std::make_shared<Box>(std::move(half_extents), std::move(centre));
}

SetPointer cross_polytope(std::vector<double> radii, std::vector<double> centre) {
  return std::make_shared<CrossPolytope>(std::move(radii), std::move(centre));
}

SetPointer point_set(Matrix points) {
  return std::make_shared<PointSet>(std::move(points));
}

}  // namespace pdg
