// The planes of a simplex's facets, as the simplicial hull wants them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pdg {

struct SimplexPlanes {
  std::vector<double> centre;  // the centroid
  // Row j: (m, delta) of the facet opposite point j, m.x = delta on it, m.centre = delta - 1.
  std::vector<double> planes;
};

// n + 1 points, one a row. None if they are affinely dependent to within rounding.
std::optional<SimplexPlanes> simplex_planes(std::size_t n, std::span<const double> points);

}  // namespace pdg
