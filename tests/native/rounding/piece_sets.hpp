// Bodies of the depth library, as inputs.
#pragma once

#include "generate.hpp"
#include "pdg/native/separation/c_obstacle_query.hpp"
#include "truth/exact.hpp"

namespace rounding {

// Two bodies, one moving, and a cell of its configurations; unscaled, as the library takes them.
struct SetCase {
  pdg::PieceSet a, b;
  pdg::Cell cell;
};

// Adversarial: in contact at the centre up to a few rounding errors; scales 1e-100 .. 1e140, far
// from the origin.
SetCase set_case(Random& random, bool adversarial);

// Two configurations of the case's moving body, angles below 2e6.
struct Move {
  pdg::Pose from, to;
};
Move move_of(Random& random, const SetCase& c, bool adversarial);

// DISP(from, to).
exact::Ball displacement_of(const pdg::PieceSet& body, const Move& move);
// What pdg::displacement may err by.
double displacement_error(const pdg::PieceSet& body, const Move& move);

exact::Box box_of(const pdg::Pose& centre, const pdg::HalfExtents& half);

}  // namespace rounding
