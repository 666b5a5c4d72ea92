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

// {diag(f) x : x in A}, factors of any sign: h(u) = h_A(diag(f) u). Powers of two do not round.
SetPointer stretched(std::vector<double> factors, SetPointer set);

// {f x : x in A}. -1 gives the reflection, so that minkowski_sum({B, scaled(-1, A)}) is the
// Minkowski difference {b - a}.
SetPointer scaled(double factor, SetPointer set);

}  // namespace pdg
