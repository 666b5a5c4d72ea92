// The proof that a cell or a face lies in C-obstacle, as evidence for certificates.
#pragma once

#include <cstdint>
#include <vector>

#include "label.hpp"
#include "pdg/native/separation/separation.hpp"
#include "planar_planner/native/configurations/dyadic_box.hpp"

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

// A weighted sum that is negative all over the cell.
using JointSum = std::vector<JointTerm>;

// All separating-axis functions of a pair that can be >= 0 somewhere in the cell.
struct PairAxes {
  struct Axis {
    pdg::EdgeOwner owner;
    std::uint16_t edge;
  };
  std::uint32_t obstacle = 0;
  std::uint16_t robot = 0;
  std::vector<Axis> axes;
};

// For every choice of one axis of each pair, one of the sums has terms of chosen axes only.
struct JointProof {
  std::vector<PairAxes> pairs;
  std::vector<JointSum> sums;

  [[nodiscard]] std::size_t bytes() const;
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
