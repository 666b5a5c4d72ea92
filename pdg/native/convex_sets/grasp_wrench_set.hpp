// Wrenches that the contacts of a grasp can apply with unit contact forces ([GFE] Eqs. 3-7), from
// closed-form support functions: no friction cone is linearised.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "convex_set.hpp"

namespace pdg {

// Primitive contact wrench sets W_i = {c_i + M_i x : |x|_2 <= 1}, i < contacts, in wrench
// coordinates of any scaling. An active set is G f_0 and sqrt(Delta) G P ([GFE] Eq. 15).
struct ContactWrenches {
  std::size_t contacts = 0;   // at least one
  std::size_t dimension = 0;  // of the wrenches
  std::size_t axes = 0;       // columns of M_i
  // Contact by contact: c_i, then the columns of M_i; contacts * (1 + axes) * dimension numbers.
  std::vector<double> columns;
};

enum class ForceNorm : std::uint8_t {
  kSum,      // L1: normal forces sum to 1
  kLargest,  // L-infinity: every normal force is 1
};

// With h_i = c_i.u + |M_i^T u| and h_i^+ = max(0, h_i), which is W_i's with the origin (a contact
// may push less):
//            idle: max h_i^+   sum h_i^+        not idle: max h_i   sum h_i
// for kSum and kLargest. Sizes are checked (std::invalid_argument).
SetPointer grasp_wrench_set(ContactWrenches wrenches, ForceNorm norm, bool idle);

}  // namespace pdg
