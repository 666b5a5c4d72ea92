// What proves that a cell or a face lies in C-obstacle: evidence for certificates.
#pragma once

#include <array>
#include <cstdint>

#include "cell.hpp"
#include "label.hpp"
#include "pdg/native/separation.hpp"

namespace planner {

// One vertex's value of one separating-axis function, and its weight (of unit normals).
struct JointTerm {
  std::uint32_t obstacle = 0;  // piece of the obstacle tree
  std::uint16_t robot = 0;     // piece of the robot
  std::uint16_t edge = 0;
  std::uint16_t vertex = 0;
  pdg::EdgeOwner owner = pdg::EdgeOwner::kObstacle;
  double weight = 0.0;
};

// A weighted sum that is negative all over the cell (joint.hpp): at most one term for each unknown
// of the linear programme, and one more.
struct JointProof {
  static constexpr std::size_t kTerms = 4;
  std::array<JointTerm, kTerms> terms;
  std::size_t count = 0;
};

// Every configuration of the closed box is in C-obstacle: by one pair, or by several together.
struct FullClaim {
  Extent box;
  Axis flat = kNoAxis;  // the normal of a face
  bool joint = false;
  Witness witness{};  // !joint
  JointProof proof;   // joint
};

}  // namespace planner
