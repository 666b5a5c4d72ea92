// Convex sets with closed-form support functions. Each is given by doubles and stands for the exact
// set that they describe; sizes of arguments are the caller's promise (checked:
// std::invalid_argument).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "convex_set.hpp"

namespace pdg {

// Dense, row by row.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> entries;  // rows x columns

  [[nodiscard]] std::span<const double> row(const std::size_t i) const {
    return std::span(entries).subspan(i * columns, columns);
  }
};

// {c + diag(r) x : |x|_2 <= 1}: h = c.u + |diag(r) u|. A ball has equal r, a point all r = 0.
SetPointer axis_ellipsoid(std::vector<double> radii, std::vector<double> centre);

// {c + M x : |x|_2 <= 1}, M of n rows and any number of columns: h = c.u + |M^T u|. With fewer
// columns than rows the set is flat: the base of a (second-order) cone.
SetPointer ellipsoid(Matrix axes, std::vector<double> centre);

// {c + x : |x_i| <= r_i}: h = c.u + sum r_i |u_i|.
SetPointer box(std::vector<double> half_extents, std::vector<double> centre);

// conv {c +- r_i e_i}: h = c.u + max r_i |u_i|.
SetPointer cross_polytope(std::vector<double> radii, std::vector<double> centre);

// conv of the rows: h = max p.u. Two rows are a segment, one is a point.
SetPointer point_set(Matrix points);

}  // namespace pdg
