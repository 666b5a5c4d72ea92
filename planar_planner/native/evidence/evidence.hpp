// What a certificate needs of the last answer, still in terms of the core's pieces and cells.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "barrier.hpp"
#include "planar_planner/native/paths/separating_edges.hpp"
#include "planar_planner/native/search/query.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// A piece as the certificate names it: its polygon, and its place in the polygon's partition.
struct PieceName {
  std::uint32_t polygon;  // kWall: `index` is the wall
  std::uint32_t index;
};

enum class ClaimKind : std::uint8_t {
  kNone,        // undecided, or nothing asked yet
  kPath,        // waypoints, segments
  kSeparation,  // barrier
  kDisc,        // barrier of a disc inside the robot
  kOddChain,    // chain
  kEnd,         // an end is not free: witness, or out of the reference bounds
};

// A pair's open sum, or what lies beyond one side of the domain (Side).
struct ChainedSet {
  std::optional<Witness> pair;
  std::uint16_t side = 0;
};

struct Evidence {
  ClaimKind kind = ClaimKind::kNone;
  std::vector<Configuration> waypoints;  // kPath: without legs into contact
  std::vector<std::vector<ProvenInterval>> segments;
  std::vector<ExactRun> exact;  // whose segments are proven exactly, by layer_evidence
  Barrier barrier;
  std::vector<ChainedSet> chain;  // each overlaps the next, the last one the first
  bool at_goal = false;           // kEnd: the goal is not free; else the start
  bool out_of_bounds = false;
  Witness witness{};
  std::vector<PieceName> robot_names, obstacle_names;  // of the pieces above
  std::vector<std::uint32_t> polygons;  // obstacles that it refers to, or whose boxes come near
  std::uint16_t disc_piece = 0;         // kDisc: the robot's piece that holds the disc
};

std::vector<PieceName> robot_names(const Robot& robot);
std::vector<PieceName> obstacle_names(const ObstacleTree& tree);

// Proves every segment of a certified path but the exact ones again, with its witnesses; false if
// one resists. `share` is that of SeparatingEdges.
bool collect_segments(const ScaledProblem& problem, ObstacleTree& tree, double share,
                      Evidence& evidence);
// Obstacle polygons whose bounding box the robot's comes near on the way.
void append_near_polygons(const ScaledProblem& problem, const ScaledConfiguration& from,
                          const ScaledConfiguration& to, std::vector<std::uint32_t>& out);
// All of them along the waypoints.
void collect_near_polygons(const ScaledProblem& problem, Evidence& evidence);
void sort_unique(std::vector<std::uint32_t>& values);
// The polygons that the barrier's claims refer to.
void collect_polygons(Evidence& evidence);

}  // namespace planner
