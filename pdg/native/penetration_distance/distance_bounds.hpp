// Rigorous bounds of d_Q(A) from planes and from a closed surface of simplices.
//
// Upper: h_A(u) / h_Q(u) for any u. Lower: let S be a closed surface of simplices with vertices in
// A that separates the origin from infinity. Then every ray from the origin meets S, in a point of
// A; if it leaves along q in Q through a facet whose vertices all have m.v >= delta, it meets S at
// t q with t >= delta / m.q >= delta / h_Q(m). So d_Q(A) >= min over the facets of delta_j /
// h_Q(m_j), for any m_j: convexity of S and exactness of normals are not needed. What the sets
// promise about rounding moves the vertices, each by at most error() per coordinate, and is taken
// off m.v.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "pdg/native/convex_sets/convex_set.hpp"
#include "pdg/native/convex_sets/vectors.hpp"
#include "pdg/native/tolerances.hpp"

namespace pdg {

// Per coordinate, a bound of |x_i| over the computed points of A. Nearer than magnitude(), which a
// composite set adds up from its parts.
inline std::vector<double> reach(const ConvexSet& a) {
  std::vector<double> u(a.dimension());
  std::vector<double> result(a.magnitude().begin(), a.magnitude().end());
  for (std::size_t i = 0; i < u.size(); ++i) {
    for (const double sign : {1.0, -1.0}) {
      u[i] = sign;
      const double extent = std::max(a.value(u), 0.0);
      result[i] = sign > 0.0 ? extent : std::max(result[i], extent);
    }
    u[i] = 0.0;
    result[i] += 2.0 * a.error()[i];
  }
  return result;
}

// Per coordinate of m: rounding of the product m.v for a computed point v of A, (n + 2) u |m|.|v|.
inline std::vector<double> product_rounding(const ConvexSet& a) {
  std::vector<double> rounding = reach(a);
  for (double& r : rounding) r *= static_cast<double>(a.dimension() + 2) * kUnitRoundoff;
  return rounding;
}

// The bound that a half-space m.x <= delta sets, in plain doubles ([GFE] Eq. 24); infinite where Q
// does not extend along m.
inline double plain_bound(const double delta, const double h_q) {
  return h_q > 0.0 ? delta / h_q : std::numeric_limits<double>::infinity();
}

// h_A(u) / h_Q(u) rounded up, from the computed values; infinite if h_Q(u) may be 0.
inline double upper_bound(const ConvexSet& a, const ConvexSet& q, const std::span<const double> u,
                          const double h_a, const double h_q) {
  const double numerator = h_a + weighted_norm(u, a.error()) * kSumPadding;
  const double denominator = h_q - weighted_norm(u, q.error()) * kSumPadding;
  if (!(denominator > 0.0)) return std::numeric_limits<double>::infinity();
  const double ratio = numerator / denominator;
  return ratio + kQuotientErrorUnits * kUnitRoundoff * std::abs(ratio);
}

// delta_j / h_Q(m_j) rounded down, delta the least computed m.v of a facet's vertices; 0 unless
// these are farther out along m than both the origin and the surface's centre.
inline double facet_bound(const ConvexSet& q, const std::span<const double> m, const double delta,
                          const double slack, const double h_q, const double centre_height) {
  const double offset = delta - slack * kSumPadding;
  if (!(offset > 0.0) || !(offset - slack * kSumPadding > centre_height)) return 0.0;
  const double extent = std::max(h_q, 0.0) + weighted_norm(m, q.error()) * kSumPadding;
  if (!(extent > 0.0)) return std::numeric_limits<double>::infinity();
  return offset / extent * (1.0 - kQuotientErrorUnits * kUnitRoundoff);
}

}  // namespace pdg
