#include "bindings_evidence.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "pieces.hpp"

namespace nb = nanobind;

namespace bindings {

namespace {

using planner::Evidence;
using planner::FullClaim;
using planner::PieceName;

nb::tuple point(const pdg::Vec2 p) {
  return nb::make_tuple(p.x, p.y);
}

const char* owner_name(const pdg::EdgeOwner owner) {
  return owner == pdg::EdgeOwner::kObstacle ? "obstacle" : "robot";
}

// k 2^-level with k odd, or 0.
nb::tuple plane(const std::uint64_t low) {
  const int zeros = low == 0 ? static_cast<int>(planner::kCoordinateBits) : std::countr_zero(low);
  const int level = std::max(0, static_cast<int>(planner::kCoordinateBits) - zeros);
  return nb::make_tuple(level, low >> (planner::kCoordinateBits - static_cast<unsigned>(level)));
}

// [level, k] along each axis; without rotation theta has no extent of its own.
nb::tuple box_tuple(const planner::Extent& e, const planner::Axis flat, const bool rotation) {
  std::array<nb::tuple, 3> sides;
  for (planner::Axis axis = 0; axis < planner::kNoAxis; ++axis) {
    const auto shift =
        e.size[axis] == 0 ? 0 : static_cast<unsigned>(std::countr_zero(e.size[axis]));
    if (axis == planner::kTheta && !rotation)
      sides[axis] = nb::make_tuple(0, 0);
    else if (axis == flat)
      sides[axis] = plane(e.low[axis]);
    else
      sides[axis] = nb::make_tuple(planner::kCoordinateBits - shift, e.low[axis] >> shift);
  }
  return nb::make_tuple(sides[0], sides[1], sides[2]);
}

// (robot polygon, piece, obstacle polygon, piece), or a wall's index.
nb::object pair_name(const Evidence& e, const std::uint32_t obstacle, const std::uint16_t robot) {
  const PieceName b = e.obstacle_names[obstacle];
  if (b.polygon == planner::kWall) return nb::int_(b.index);
  const PieceName a = e.robot_names[robot];
  return nb::make_tuple(a.polygon, a.index, b.polygon, b.index);
}

nb::list terms_list(const planner::Planner& of, const Evidence& e,
                    const planner::JointProof& proof) {
  nb::list out;
  const int exponent = of.problem().frame.exponent;
  for (std::size_t k = 0; k < proof.count; ++k) {
    const planner::JointTerm& t = proof.terms[k];
    nb::object vertex = nb::int_(t.vertex);
    if (e.obstacle_names[t.obstacle].polygon == planner::kWall) {
      const pdg::Vec2 v = of.problem().robot.pieces[t.robot].edges[t.vertex].vertex;
      vertex = point({std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)});
    }
    out.append(nb::make_tuple(pair_name(e, t.obstacle, t.robot), owner_name(t.owner), t.edge,
                              vertex, t.weight));
  }
  return out;
}

nb::list claims_list(const planner::Planner& of, const Evidence& e,
                     const std::vector<FullClaim>& claims) {
  nb::list out;
  for (const FullClaim& claim : claims) {
    nb::dict item;
    item["box"] = box_tuple(claim.box, claim.flat, of.problem().rotation);
    if (claim.flat != planner::kNoAxis) item["axis"] = claim.flat;
    if (claim.joint)
      item["joint"] = terms_list(of, e, claim.proof);
    else
      item["pair"] = pair_name(e, claim.witness.obstacle, claim.witness.robot);
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
    out[nb::int_(p)] = pieces;
  }
  return out;
}

nb::list segments_list(const Evidence& e) {
  nb::list segments;
  for (const std::vector<planner::ProvenInterval>& segment : e.segments) {
    nb::list intervals;
    for (const planner::ProvenInterval& proven : segment) {
      nb::list edges;
      for (const planner::SeparatingEdge& edge : proven.edges)
        edges.append(nb::make_tuple(pair_name(e, edge.obstacle, edge.robot), owner_name(edge.owner),
                                    edge.edge));
      intervals.append(nb::make_tuple(proven.interval.begin, proven.interval.end, edges));
    }
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
    boxes.append(box_tuple(planner::extent_of(box), planner::kNoAxis, of.problem().rotation));
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
    out["outside"] = nb::make_tuple(outside.low.x, outside.low.y, outside.high.x, outside.high.y);
  }
  switch (e.kind) {
    case planner::ClaimKind::kPath: {
      nb::list waypoints;
      for (const planner::Configuration& q : e.waypoints)
        waypoints.append(nb::make_tuple(q.x, q.y, q.theta));
      out["waypoints"] = waypoints;
      out["segments"] = segments_list(e);
      break;
    }
    case planner::ClaimKind::kDisc: {
      nb::list disc;
      for (const pdg::Vec2 v : scene.robot.points) disc.append(point(v));
      out["disc"] = disc;
      const PieceName holder = planner::robot_names(planner.problem().robot)[e.disc_piece];
      out["inside"] = nb::make_tuple(holder.polygon, holder.index);
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
        out["pair"] = pair_name(e, e.witness.obstacle, e.witness.robot);
      break;
    case planner::ClaimKind::kNone:
      break;
  }
  return out;
}

}  // namespace bindings
