// The evidence that a straight motion is free: parts of it, and for every pair of pieces that comes
// near on a part one edge that separates it there (docs/certificate.md, "path").
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pdg/native/separation/separation.hpp"
#include "planar_planner/native/configurations/scaled_configuration.hpp"
#include "planar_planner/native/world/obstacle_tree.hpp"
#include "planar_planner/native/world/posed_robot.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "segment.hpp"

namespace planner {

struct SeparatingEdge {
  std::uint32_t obstacle;  // piece of the obstacle tree
  std::uint16_t robot;     // piece of the robot
  std::uint16_t edge;      // of its owner
  pdg::EdgeOwner owner;
};

// A pair that the line of a translation separates: the obstacle's piece, less the robot's, lies on
// one side of it.
struct SeparatingLine {
  std::uint32_t obstacle;
  std::uint16_t robot;
  bool obstacle_left;
};

struct ProvenInterval {
  Interval interval;
  std::vector<SeparatingEdge> edges;  // pairs whose bounding boxes do not prove them apart
  std::vector<SeparatingLine> lines;  // the same, of exact paths
};

class SeparatingEdges {
 public:
  // Edges have to separate by `share` of the rounding error of their functions. With 1 they do
  // separate. With less an exact check has to follow: it succeeds where the rounding is less than
  // its bound.
  SeparatingEdges(const ScaledProblem& problem, ObstacleTree& tree, const double share)
      : problem_(problem), tree_(tree), share_(share), posed_(problem.robot) {}

  // Ablation that follow one another from 0 to 1; empty if the motion is not free, or if it would
  // take too many. Whatever SegmentTest certifies passes: this bound shrinks with the square of the
  // interval as its does.
  std::optional<std::vector<ProvenInterval>> prove(const ScaledConfiguration& from,
                                                   const ScaledConfiguration& to);

 private:
  struct Box {
    Vec2 low, high;
  };
  struct Part;

  // Nodes of the obstacle tree that are pieces, or polygons that nobody has decomposed yet.
  using Nodes = std::vector<std::uint32_t>;

  bool gather(std::uint32_t node, const Box& swept, bool open, Nodes& out);
  bool prove_part(Interval interval, const Nodes& near, int depth);
  Part make_part(Interval interval);
  bool separate(const Part& part, const Nodes& near, ProvenInterval& out);
  bool within_walls(const Part& part);

  const ScaledProblem& problem_;
  ObstacleTree& tree_;
  double share_;
  ScaledConfiguration from_, to_;
  PosedRobot posed_;
  std::vector<ProvenInterval> proven_;
};

// Holds the bounding boxes of the robot on every part of the way.
struct SweptBox {
  Vec2 low, high;
};
SweptBox swept_box(const ScaledProblem& problem, const ScaledConfiguration& from,
                   const ScaledConfiguration& to);
// Rounding of the comparison of a swept box with an obstacle's.
double box_margin(const ScaledProblem& problem, Vec2 low, Vec2 high);

}  // namespace planner
