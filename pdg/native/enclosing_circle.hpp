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

// The same with both sides of its radius. Weights l_v >= 0 of sum 1 on at most three points prove,
// with c = sum l_v v and for every t,
//   max_v |t + v - c|^2 >= sum l_v |t + v - c|^2 = |t|^2 + sum l_v |v - c|^2,
// so `inner` bounds the radius of every enclosing circle from below, however good the weights are.
struct CircleBounds {
  Vec2 centre;         // c, up to 8 u max |v|
  double inner = 0.0;  // sqrt(sum l_v |v - c|^2), rounded down
  double outer = 0.0;  // max |v - c|, rounded up; equal to `inner` but for rounding
};

CircleBounds enclosing_circle_bounds(const std::vector<Vec2>& points);

}  // namespace pdg
