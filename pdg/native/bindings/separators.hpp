// The class by which Python holds a body's convex separators.
#pragma once

#include <vector>

#include "pdg/native/bounds/convex_separators.hpp"

namespace pdg::python {

struct SeparatorSet {
  std::vector<pdg::ConvexSeparator> separators;
};

}  // namespace pdg::python
