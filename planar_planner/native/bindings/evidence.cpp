#include "evidence.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "planar_planner/native/world/pieces.hpp"

namespace nb = nanobind;

namespace bindings {

namespace {

using planner::Evidence;
using planner::FullClaim;
using planner::PieceName;

template <class... Values>
nb::list list_of(const Values&... values) {
  nb::list out;
  (out.append(values), ...);
  return out;
}

nb::list point(const pdg::Vec2 p) {
  return list_of(p.x, p.y);
}

const char* owner_name(const pdg::EdgeOwner owner) {
  return owner == pdg::EdgeOwner::kObstacle ? "obstacle" : "robot";
}

// k 2^-level with k odd, or 0.
nb::list plane(const std::uint64_t low) {
  const int zeros = low == 0 ? static_cast<int>(planner::kCoordinateBits) : std::countr_zero(low);
  const int level = std::max(0, static_cast<int>(planner::kCoordinateBits) - zeros);
  return list_of(level, low >> (planner::kCoordinateBits - static_cast<unsigned>(level)));
}

// [level, k] along each axis; without rotation theta has no extent of its own.
nb::list box_list(const planner::Extent& e, const planner::Axis flat, const bool rotation) {
  nb::list sides;
  for (planner::Axis axis = 0; axis < planner::kNoAxis; ++axis) {
    const auto shift =
        e.size[axis] == 0 ? 0 : static_cast<unsigned>(std::countr_zero(e.size[axis]));
    if (axis == planner::kTheta && !rotation)
      sides.append(list_of(0, 0));
    else if (axis == flat)
      sides.append(plane(e.low[axis]));
    else
      sides.append(list_of(planner::kCoordinateBits - shift, e.low[axis] >> shift));
  }
  return sides;
}

nb::list pair_list(const Evidence& e, const std::uint32_t obstacle, const std::uint16_t robot) {
  const PieceName a = e.robot_names[robot];
  const PieceName b = e.obstacle_names[obstacle];
  return list_of(a.polygon, a.index, b.polygon, b.index);
}

// {"pair": [robot polygon, piece, obstacle polygon, piece]} or {"wall": name}.
nb::dict subject(const Evidence& e, const std::uint32_t obstacle, const std::uint16_t robot) {
  constexpr std::array<const char*, 4> walls{"x_min", "x_max", "y_min", "y_max"};
  nb::dict out;
  if (e.obstacle_names[obstacle].polygon == planner::kWall)
    out["wall"] = walls[e.obstacle_names[obstacle].index];
  else
    out["pair"] = pair_list(e, obstacle, robot);
  return out;
}

// The edges of each pair that may separate it; a wall has only its own.
nb::list axes_list(const Evidence& e, const planner::JointProof& proof) {
  nb::list out;
  for (const planner::PairAxes& pair : proof.pairs) {
    if (e.obstacle_names[pair.obstacle].polygon == planner::kWall) continue;
    nb::list edges;
    for (const planner::PairAxes::Axis& axis : pair.axes)
      edges.append(list_of(owner_name(axis.owner), axis.edge));
    nb::dict item;
    item["pair"] = pair_list(e, pair.obstacle, pair.robot);
    item["edges"] = edges;
    out.append(item);
  }
  return out;
}

nb::dict term_dict(const planner::Planner& of, const Evidence& e, const planner::JointTerm& term) {
  nb::dict out = subject(e, term.obstacle, term.robot);
  if (e.obstacle_names[term.obstacle].polygon == planner::kWall) {
    const int exponent = of.problem().frame.exponent;
    const pdg::Vec2 v = of.problem().robot.pieces[term.robot].edges[term.vertex].vertex;
    out["vertex"] = point({std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)});
  } else {
    out["owner"] = owner_name(term.owner);
    out["edge"] = term.edge;
    out["vertex"] = term.vertex;
  }
  out["weight"] = term.weight;
  return out;
}

nb::dict joint_dict(const planner::Planner& of, const Evidence& e,
                    const planner::JointProof& proof) {
  nb::list sums;
  for (const planner::JointSum& sum : proof.sums) {
    nb::list terms;
    for (const planner::JointTerm& term : sum) terms.append(term_dict(of, e, term));
    sums.append(terms);
  }
  nb::dict out;
  out["axes"] = axes_list(e, proof);
  out["sums"] = sums;
  return out;
}

nb::list claims_list(const planner::Planner& of, const Evidence& e,
                     const std::vector<FullClaim>& claims) {
  nb::list out;
  for (const FullClaim& claim : claims) {
    nb::dict item =
        claim.joint ? nb::dict() : subject(e, claim.witness.obstacle, claim.witness.robot);
    item["box"] = box_list(claim.box, claim.flat, of.problem().rotation);
    if (claim.flat != planner::kNoAxis) item["axis"] = claim.flat;
    if (claim.joint) item["joint"] = joint_dict(of, e, claim.proof);
    out.append(item);
  }
  return out;
}

nb::dict pieces_dict(const planner::PolygonSet& set, const std::vector<std::uint32_t>& polygons) {
  nb::dict out;
  for (const std::uint32_t p : polygons) {
    nb::list pieces;
    for (const pdg::ConvexPolygon& piece : planner::planner_pieces(set.polygon(p))) {
      nb::list vertices;
      for (const pdg::Vec2 v : piece) vertices.append(point(v));
      pieces.append(vertices);
    }
    out[std::to_string(p).c_str()] = pieces;
  }
  return out;
}

nb::dict interval_dict(const Evidence& e, const planner::ProvenInterval& proven) {
  nb::list apart;
  for (const planner::SeparatingEdge& edge : proven.edges) {
    nb::list item = pair_list(e, edge.obstacle, edge.robot);
    item.append(owner_name(edge.owner));
    item.append(edge.edge);
    apart.append(item);
  }
  nb::dict out;
  out["from"] = proven.interval.begin;
  out["to"] = proven.interval.end;
  out["apart"] = apart;
  return out;
}

nb::list segments_list(const Evidence& e) {
  nb::list segments;
  for (const std::vector<planner::ProvenInterval>& segment : e.segments) {
    nb::list intervals;
    for (const planner::ProvenInterval& proven : segment)
      intervals.append(interval_dict(e, proven));
    segments.append(intervals);
  }
  return segments;
}

nb::dict domain_dict(const planner::Problem& problem) {
  nb::dict out;
  out["low"] = point(problem.domain.low);
  out["size"] = point(problem.domain.size);
  out["origin"] = point(problem.frame.origin);
  out["exponent"] = problem.frame.exponent;
  return out;
}

void add_barrier(const planner::Planner& of, const Evidence& e, nb::dict& out) {
  out["domain"] = domain_dict(of.problem());
  nb::list boxes;
  for (const planner::CellBox& box : e.barrier.start_side)
    boxes.append(box_list(planner::extent_of(box), planner::kNoAxis, of.problem().rotation));
  out["start_side"] = boxes;
  out["full"] = claims_list(of, e, e.barrier.cells);
  out["full_faces"] = claims_list(of, e, e.barrier.faces);
}

}  // namespace

nb::dict evidence(planner::Planner& planner) {
  Evidence e;
  {
    const nb::gil_scoped_release release;
    e = planner.evidence();
  }
  constexpr std::array<const char*, 5> kinds{"none", "path", "separation", "disc", "end"};
  const planner::Planner& of =
      e.kind == planner::ClaimKind::kDisc ? planner.disc_inside() : planner;
  const planner::Scene& scene = of.problem().scene;
  nb::dict out;
  out["kind"] = kinds[static_cast<std::size_t>(e.kind)];
  if (e.kind == planner::ClaimKind::kNone) return out;
  std::vector<std::uint32_t> robot_polygons;
  for (std::uint32_t p = 0; p < planner.problem().scene.robot.size(); ++p)
    robot_polygons.push_back(p);
  out["robot_pieces"] = pieces_dict(planner.problem().scene.robot, robot_polygons);
  out["obstacle_pieces"] = pieces_dict(scene.obstacles, e.polygons);
  if (scene.workspace) {
    const planner::Rectangle outside = scene.obstacles.bounds(of.problem().user_obstacles);
    out["outside"] = list_of(outside.low.x, outside.low.y, outside.high.x, outside.high.y);
  }
  switch (e.kind) {
    case planner::ClaimKind::kPath: {
      nb::list waypoints;
      for (const planner::Configuration& q : e.waypoints)
        waypoints.append(list_of(q.x, q.y, q.theta, 0));
      out["waypoints"] = waypoints;
      out["segments"] = segments_list(e);
      break;
    }
    case planner::ClaimKind::kDisc: {
      nb::list disc;
      for (const pdg::Vec2 v : scene.robot.points) disc.append(point(v));
      out["disc"] = disc;
      const PieceName holder = planner::robot_names(planner.problem().robot)[e.disc_piece];
      out["inside"] = list_of(holder.polygon, holder.index);
      add_barrier(of, e, out);
      break;
    }
    case planner::ClaimKind::kSeparation:
      add_barrier(of, e, out);
      break;
    case planner::ClaimKind::kEnd:
      out["end"] = e.end;
      if (e.out_of_bounds)
        out["reference_bounds"] = true;
      else
        out["witness"] = subject(e, e.witness.obstacle, e.witness.robot);
      break;
    case planner::ClaimKind::kNone:
      break;
  }
  return out;
}

}  // namespace bindings
