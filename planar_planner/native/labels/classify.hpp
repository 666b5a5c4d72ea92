// The one decision about a closed set of configurations, a cell or a face: FREE, FULL or MIXED by
// single pairs of pieces; a MIXED one may still be FULL by several pairs together, or STAR.
#pragma once

#include <array>
#include <optional>

#include "constraints.hpp"
#include "full_claim.hpp"
#include "joint.hpp"
#include "label.hpp"
#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/world/posed_robot.hpp"
#include "star.hpp"

namespace planner {

// The questions that a set which is MIXED by single pairs is asked. Obstruction by several pairs
// and the star test exclude each other (a guard is free), so their order decides what they cost,
// not what comes out.
struct Questions {
  bool star_first = false;
  // Joint obstruction, even where the centre looks free by the labelling's hint.
  bool joint_if_centre_looks_free = false;
  // What stays MIXED and has a motion radius below this part of the robot's reach is asked along
  // which axes halving it often enough would settle it. 0: nothing is.
  double settle_below = 0.0;
};

struct Classification {
  Label label = Label::kMixed;
  Witness witness{};                // kFull, if by one pair
  std::optional<JointProof> joint;  // kFull, if by several
  Vec2 guard;                // kStar: its translation, planner units, at the central rotation
  ConstraintList undecided;  // kStar, kMixed: for parts of the set
  // kMixed, asked: by pdg::MotionPart, would the set, made flat along that part, be FULL or STAR?
  std::array<bool, 3> settles{};
  double separation = 0.0;  // LabelResult's hints
  pdg::Sway sway;
  double turning_radius = 0.0;
  double motion_radius = 0.0;  // planner units: how far the set moves the active pieces; a hint
};

// Memory that classify() works in. `room` may be given back the list of an earlier result, for its
// memory; no result depends on what is in here.
struct Scratch {
  ConstraintList room;
  JointTerms terms;
  JointScratch joint;
  StarScratch star;
};

// `posed` is turned to the motion's central rotation; `parent` is the undecided list of a set that
// holds this one.
Classification classify(Labeller& labeller, const pdg::Motion& motion, PosedRobot& posed,
                        const ConstraintView& parent, const Questions& questions, Scratch& scratch);

}  // namespace planner
