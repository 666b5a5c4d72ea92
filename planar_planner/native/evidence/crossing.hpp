// A way of least overlap between two configurations, on a lattice about them: what sharpens a
// bottleneck that leaves of a subdivision have shown roughly.
#pragma once

#include <functional>
#include <vector>

#include "planar_planner/native/world/problem.hpp"

namespace planner {

// How deep a configuration is in collision, user's units; 0 if it is free.
using DepthAt = std::function<double(const Configuration&)>;

struct Crossing {
  std::vector<Configuration> way;
  std::vector<double> depth;  // of each of `way`; 0 where nothing is known to collide
  std::size_t deepest = 0;    // index of the bottleneck, the deepest before any sharpening
};

// Index of the first that is deepest.
std::size_t deepest_of(const std::vector<double>& depth);

// Greatest depth at some configurations evenly between two.
double depth_between(const Configuration& a, const Configuration& b, const DepthAt& depth_at);

// Theta of the ends may not be more than half a turn apart. `radius` is the length that a turn by
// one radian counts as, in the user's unit; 0: theta is the same everywhere.
Crossing least_overlap(const Configuration& from, const Configuration& to, double radius,
                       const DepthAt& depth_at);

// Again and again replaces the stretch about the deepest, out to where the way is less deep, by a
// way of no more overlap, if a lattice has one. `crossing` must not be empty.
void sharpen(Crossing& crossing, double radius, const DepthAt& depth_at);

}  // namespace planner
