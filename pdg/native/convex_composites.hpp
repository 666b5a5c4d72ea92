// Convex sets made of others: Minkowski sum, convex hull of a union, affine image, scaled copy.
#pragma once

#include <vector>

#include "convex_bodies.hpp"
#include "convex_set.hpp"

namespace pdg {

// All sets of one dimension, at least one (else std::invalid_argument).
// A_1 + ... + A_m: h = sum h_i.
SetPointer minkowski_sum(std::vector<SetPointer> sets);

// conv (A_1 u ... u A_m): h = max h_i.
SetPointer union_hull(std::vector<SetPointer> sets);

// {M x + c : x in A}: h(u) = h_A(M^T u) + c.u. M has as many columns as A has dimensions.
SetPointer affine_image(Matrix map, std::vector<double> offset, SetPointer set);

// {f x : x in A}, f of any sign: h(u) = h_A(f u). -1 gives the reflection, so that
// minkowski_sum({B, scaled(-1, A)}) is the Minkowski difference {b - a}.
SetPointer scaled(double factor, SetPointer set);

}  // namespace pdg
