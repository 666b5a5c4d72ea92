// The evidence of the last answer in the user's terms, as plain structs: pieces named by polygon
// and place, boxes by dyadic fractions, lengths in the user's unit. planning/certificate.py makes a
// certificate of it and is the only place that knows the certificate's keys and words.
#pragma once

#include <nanobind/nanobind.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "planar_planner/native/planning/planner.hpp"

namespace bindings {

using Point = std::array<double, 2>;
using Vertices = std::vector<Point>;
using PairName = std::array<std::uint32_t, 4>;  // robot's polygon and piece, obstacle's the same
using Span = std::array<std::uint64_t, 2>;      // l, k: from k 2^-l to (k + 1) 2^-l; or k 2^-l
using Box = std::array<Span, 3>;                // along x and y of the domain, theta of turns

// A polygon of the scene and its partition into convex pieces.
struct NamedPolygon {
  std::uint32_t polygon = 0;
  std::vector<Vertices> pieces;
};

struct NamedEdge {
  bool of_obstacle = true;  // else of the robot
  std::uint32_t edge = 0;
};

// What collides: a pair of pieces, or the robot with a wall (x_min, x_max, y_min, y_max).
struct NamedCollision {
  std::optional<PairName> pair;
  std::optional<std::uint32_t> wall;
};

// The edges that may separate a pair somewhere in a box.
struct NamedPairEdges {
  PairName pair{};
  std::vector<NamedEdge> edges;
};

// One vertex's value of one separating-axis function.
struct NamedTerm {
  NamedCollision of;
  NamedEdge edge;            // of a pair
  std::uint32_t vertex = 0;  // of the other piece of a pair
  Point wall_vertex{};       // of the robot, for a wall
  double weight = 0.0;       // of unit normals
};

struct NamedJoint {
  std::vector<NamedPairEdges> pairs;
  std::vector<std::vector<NamedTerm>> sums;
};

// Every configuration of a box or a face is in C-obstacle: by one collision, or jointly.
struct NamedClaim {
  Box box{};
  std::optional<std::uint32_t> axis;  // the normal of a face
  NamedCollision collision;           // without `joint`
  std::optional<NamedJoint> joint;
};

struct NamedSeparator {
  PairName pair{};
  NamedEdge edge;
};

// The line of the segment separates this pair: the obstacle's piece is on this side of it.
struct NamedLine {
  PairName pair{};
  bool obstacle_left = true;
};

// Part of a segment, and an edge for each pair that bounding boxes do not prove apart.
struct NamedInterval {
  double begin = 0.0, end = 0.0;
  std::vector<NamedSeparator> separators;
  std::vector<NamedLine> lines;
};

// The domain is origin + 2^-exponent [low, low + size], exactly.
struct NamedDomain {
  Point origin{}, low{}, size{};
  int exponent = 0;
};

struct NamedEvidence {
  planner::ClaimKind kind = planner::ClaimKind::kNone;
  // kSeparation, kDisc: the point of the robot's frame that translations and the robot's pieces are
  // about, if it is not the origin.
  std::optional<Point> reference;
  std::vector<NamedPolygon> robot_pieces, obstacle_pieces;
  std::optional<std::array<double, 4>> outside;  // of a polygonal workspace: the frame around it
  // kPath
  std::vector<std::array<double, 3>> waypoints;
  std::vector<std::vector<NamedInterval>> segments;
  // kSeparation, kDisc
  NamedDomain domain;
  std::vector<Box> start_side;
  std::vector<NamedClaim> full, full_faces;
  // kDisc
  Vertices disc;
  std::array<std::uint32_t, 2> disc_holder{};  // polygon and piece of the robot
  // kOddChain: pairs, and sides of the domain (the walls' numbers)
  std::vector<NamedCollision> chain;
  // kEnd
  bool goal_end = false;  // else the start
  bool out_of_bounds = false;
  NamedCollision collision;  // unless out of bounds
};

NamedEvidence evidence(planner::Planner& planner);

// Adds the structs above to the module.
void add_evidence(nanobind::module_& m);

}  // namespace bindings
