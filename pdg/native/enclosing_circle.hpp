// The smallest circle round points.
#pragma once

#include <vector>

#include "vec.hpp"

namespace pdg {

struct Circle {
  Vec2 centre;
  double radius = 0.0;
};

// Welzl's incremental method over a fixed shuffled order: linear expected time, same answer each
// time. Plain doubles: the radius is rounded so that no point lies outside by more than a few u of
// it. A turn by phi moves some point round which the circle is drawn by 2 sin(|phi| / 2) radius at
// least, whatever the translation.
Circle smallest_enclosing_circle(std::vector<Vec2> points);

}  // namespace pdg
