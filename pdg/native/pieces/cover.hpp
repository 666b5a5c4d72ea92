// Growth of a convex partition into a convex cover.
#pragma once

#include <vector>

#include "pdg/native/triangulation/point_mesh.hpp"

namespace pdg {

// A convex part: indices of points, counter-clockwise, weakly convex.
using Part = std::vector<Index>;

// `parts` tile a region and neighbours share whole edges. Returns parts that lie inside the region,
// use its points only and cover it: each given part is grown into its neighbours as far as it stays
// convex, and the parts that others contain are left out.
std::vector<Part> grow_to_cover(const std::vector<Vec2>& points, const std::vector<Part>& parts);

}  // namespace pdg
