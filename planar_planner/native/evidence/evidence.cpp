#include "evidence.hpp"

#include <algorithm>

namespace planner {

void sort_unique(std::vector<std::uint32_t>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

void append_near_polygons(const ScaledProblem& problem, const ScaledConfiguration& from,
                          const ScaledConfiguration& to, std::vector<std::uint32_t>& out) {
  const SweptBox swept = swept_box(problem, from, to);
  const Obstacles obstacles = all_obstacles(problem);
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Rectangle box = obstacles.bounds(i);
    const Vec2 low = to_planner(problem, box.low);
    const Vec2 high = to_planner(problem, box.high);
    const double margin = box_margin(problem, low, high);
    if (low.x - margin <= swept.high.x && swept.low.x <= high.x + margin &&
        low.y - margin <= swept.high.y && swept.low.y <= high.y + margin)
      out.push_back(static_cast<std::uint32_t>(i));
  }
}

std::vector<PieceName> robot_names(const Robot& robot) {
  std::vector<PieceName> names;
  for (std::size_t i = 0; i < robot.body_pieces(); ++i) {
    const std::uint32_t polygon = robot.polygon_of_piece[i];
    const bool again = i > 0 && names.back().polygon == polygon;
    names.push_back({polygon, again ? names.back().index + 1 : 0});
  }
  return names;
}

// A polygon is decomposed at once, so its pieces follow one another.
std::vector<PieceName> obstacle_names(const ObstacleTree& tree) {
  std::vector<PieceName> names;
  for (std::uint32_t i = 0; i < tree.piece_count(); ++i) {
    const std::uint32_t polygon = tree.polygon_of_piece(i);
    const bool again = i > 0 && names.back().polygon == polygon;
    names.push_back({polygon, again ? names.back().index + 1 : 0});
  }
  return names;
}

bool collect_segments(const ScaledProblem& problem, ObstacleTree& tree, const double share,
                      Evidence& evidence) {
  evidence.segments.clear();
  SeparatingEdges edges(problem, tree, share);
  auto run = evidence.exact.begin();
  for (std::size_t i = 0; i + 1 < evidence.waypoints.size(); ++i) {
    if (run != evidence.exact.end() && i == run->last) ++run;
    if (run != evidence.exact.end() && i >= run->first) {
      evidence.segments.emplace_back();
      continue;
    }
    const ScaledConfiguration from = scaled(problem, evidence.waypoints[i]);
    const ScaledConfiguration to = scaled(problem, evidence.waypoints[i + 1]);
    auto proof = edges.prove(from, to);
    if (!proof) return false;
    evidence.segments.push_back(std::move(*proof));
  }
  return true;
}

void collect_near_polygons(const ScaledProblem& problem, Evidence& evidence) {
  for (std::size_t i = 0; i + 1 < evidence.waypoints.size(); ++i)
    append_near_polygons(problem, scaled(problem, evidence.waypoints[i]),
                         scaled(problem, evidence.waypoints[i + 1]), evidence.polygons);
  sort_unique(evidence.polygons);
}

void collect_polygons(Evidence& evidence) {
  const auto add = [&](const std::uint32_t piece) {
    const std::uint32_t polygon = evidence.obstacle_names[piece].polygon;
    if (polygon != kWall) evidence.polygons.push_back(polygon);
  };
  for (const std::vector<FullClaim>* claims : {&evidence.barrier.cells, &evidence.barrier.faces})
    for (const FullClaim& claim : *claims) {
      if (!claim.joint) add(claim.witness.obstacle);
      for (const PairAxes& pair : claim.proof.pairs) add(pair.obstacle);
    }
  if (evidence.kind == ClaimKind::kEnd && !evidence.out_of_bounds) add(evidence.witness.obstacle);
  sort_unique(evidence.polygons);
}

}  // namespace planner
