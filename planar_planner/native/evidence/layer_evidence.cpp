#include "layer_evidence.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace planner {

namespace {

struct Motion {
  LatticePoint from, to;
};

// Does edge k of the polygon, at one translation, have all points on its outer side or on itself?
bool separates(const LatticePolygon& polygon, const std::size_t k, const LatticePoint own,
               const LatticePolygon& others, const LatticePoint shift) {
  const LatticePoint a = polygon[k] + own;
  const LatticePoint b = polygon[(k + 1) % polygon.size()] + own;
  return std::all_of(others.begin(), others.end(),
                     [&](const LatticePoint p) { return orientation(a, b, p + shift) <= 0; });
}

// An edge of the obstacle's or of the robot's piece that separates them at both ends of the motion,
// and so all along it.
std::optional<SeparatingEdge> separating_edge(const LatticePolygon& robot,
                                              const LatticePolygon& obstacle,
                                              const Motion& motion) {
  constexpr LatticePoint still{};
  for (std::size_t k = 0; k < obstacle.size(); ++k)
    if (separates(obstacle, k, still, robot, motion.from) &&
        separates(obstacle, k, still, robot, motion.to))
      return SeparatingEdge{0, 0, static_cast<std::uint16_t>(k), pdg::EdgeOwner::kObstacle};
  for (std::size_t k = 0; k < robot.size(); ++k)
    if (separates(robot, k, motion.from, obstacle, still) &&
        separates(robot, k, motion.to, obstacle, still))
      return SeparatingEdge{0, 0, static_cast<std::uint16_t>(k), pdg::EdgeOwner::kRobot};
  return std::nullopt;
}

ProvenInterval prove(const Layer& layer, const Motion& motion, std::vector<std::int32_t>& near) {
  ProvenInterval proven{{0.0, 1.0}, {}, {}};
  find_near(layer, motion.from, motion.to, near);
  for (const std::int32_t i : near) {
    const OpenSum& sum = layer.sums[static_cast<std::size_t>(i)];
    const auto robot = static_cast<std::uint16_t>(sum.robot_piece);
    auto edge = separating_edge(layer.robot[sum.robot_piece].vertices,
                                layer.obstacles[sum.obstacle_piece].vertices, motion);
    if (edge) {
      edge->obstacle = sum.obstacle_piece;
      edge->robot = robot;
      proven.edges.push_back(*edge);
      continue;
    }
    const bool left = std::all_of(sum.vertices.begin(), sum.vertices.end(), [&](LatticePoint p) {
      return orientation(motion.from, motion.to, p) >= 0;
    });
    proven.lines.push_back({sum.obstacle_piece, robot, left});
  }
  return proven;
}

void name_pieces(const Layer& layer, Evidence& evidence) {
  for (const LayerPiece& piece : layer.robot)
    evidence.robot_names.push_back({piece.polygon, piece.index});
  for (const LayerPiece& piece : layer.obstacles)
    evidence.obstacle_names.push_back({piece.polygon, piece.index});
}

}  // namespace

Evidence path_evidence(const ScaledProblem& problem, const Layer& layer,
                       const std::vector<Configuration>& waypoints) {
  Evidence evidence;
  evidence.kind = ClaimKind::kPath;
  evidence.waypoints = waypoints;
  name_pieces(layer, evidence);
  std::vector<std::int32_t> near;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const Configuration& from = waypoints[i];
    const Configuration& to = waypoints[i + 1];
    const Motion motion{to_lattice(layer.lattice, Vec2{from.x, from.y}),
                        to_lattice(layer.lattice, Vec2{to.x, to.y})};
    evidence.segments.push_back({prove(layer, motion, near)});
    append_near_polygons(problem, scaled(problem, from), scaled(problem, to), evidence.polygons);
  }
  sort_unique(evidence.polygons);
  return evidence;
}

void prove_exact_legs(const std::span<const Layer> layers, Evidence& evidence) {
  std::vector<std::int32_t> near;
  for (const ExactRun& run : evidence.exact) {
    const Layer& layer = layers[run.layer];
    const std::size_t robots = evidence.robot_names.size();
    const std::size_t obstacles = evidence.obstacle_names.size();
    name_pieces(layer, evidence);
    const auto at = [&](const std::size_t i) {
      const Configuration& q = evidence.waypoints[i];
      return to_lattice(layer.lattice, Vec2{q.x, q.y});
    };
    const auto rename = [&](auto& pair) {
      pair.robot = static_cast<std::uint16_t>(pair.robot + robots);
      pair.obstacle += static_cast<std::uint32_t>(obstacles);
    };
    for (std::size_t i = run.first; i < run.last; ++i) {
      ProvenInterval proven = prove(layer, {at(i), at(i + 1)}, near);
      for (SeparatingEdge& edge : proven.edges) rename(edge);
      for (SeparatingLine& line : proven.lines) rename(line);
      evidence.segments[i] = {std::move(proven)};
    }
  }
}

Evidence end_evidence(const Layer& layer, const ChainLink in, const bool at_goal) {
  Evidence evidence;
  evidence.kind = ClaimKind::kEnd;
  evidence.at_goal = at_goal;
  name_pieces(layer, evidence);
  if (in < 0) {
    evidence.witness = {static_cast<std::uint32_t>(evidence.obstacle_names.size()), 0};
    evidence.obstacle_names.push_back({kWall, static_cast<std::uint32_t>(-1 - in)});
    return evidence;
  }
  const OpenSum& sum = layer.sums[static_cast<std::size_t>(in)];
  evidence.witness = {sum.obstacle_piece, static_cast<std::uint16_t>(sum.robot_piece)};
  evidence.polygons = {layer.obstacles[sum.obstacle_piece].polygon};
  return evidence;
}

Evidence chain_evidence(const Layer& layer, const std::vector<ChainLink>& chain) {
  Evidence evidence;
  evidence.kind = ClaimKind::kOddChain;
  name_pieces(layer, evidence);
  for (const ChainLink link : chain) {
    if (link < 0) {
      evidence.chain.push_back({std::nullopt, static_cast<std::uint16_t>(-1 - link)});
      continue;
    }
    const OpenSum& sum = layer.sums[static_cast<std::size_t>(link)];
    evidence.chain.push_back(
        {Witness{sum.obstacle_piece, static_cast<std::uint16_t>(sum.robot_piece)}, 0});
    evidence.polygons.push_back(layer.obstacles[sum.obstacle_piece].polygon);
  }
  sort_unique(evidence.polygons);
  return evidence;
}

}  // namespace planner
