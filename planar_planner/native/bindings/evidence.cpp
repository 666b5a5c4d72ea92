#include "evidence.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "planar_planner/native/world/pieces.hpp"

namespace nb = nanobind;

namespace bindings {

namespace {

using planner::Evidence;
using planner::PieceName;

Point point(const pdg::Vec2 p) {
  return {p.x, p.y};
}

bool of_obstacle(const pdg::EdgeOwner owner) {
  return owner == pdg::EdgeOwner::kObstacle;
}

bool is_wall(const Evidence& e, const std::uint32_t obstacle) {
  return e.obstacle_names[obstacle].polygon == planner::kWall;
}

// k 2^-level with k odd, or 0.
Span plane(const std::uint64_t low) {
  const int zeros = low == 0 ? static_cast<int>(planner::kCoordinateBits) : std::countr_zero(low);
  const int level = std::max(0, static_cast<int>(planner::kCoordinateBits) - zeros);
  const auto bits = static_cast<unsigned>(level);
  return {bits, low >> (planner::kCoordinateBits - bits)};
}

// Without rotation theta has no extent of its own.
Box box_of(const planner::Extent& e, const planner::Axis flat, const bool rotation) {
  Box box{};
  for (planner::Axis axis = 0; axis < planner::kNoAxis; ++axis) {
    const auto shift =
        e.size[axis] == 0 ? 0U : static_cast<unsigned>(std::countr_zero(e.size[axis]));
    if (axis == planner::kTheta && !rotation)
      box[axis] = {0, 0};
    else if (axis == flat)
      box[axis] = plane(e.low[axis]);
    else
      box[axis] = {planner::kCoordinateBits - shift, e.low[axis] >> shift};
  }
  return box;
}

PairName pair_name(const Evidence& e, const std::uint32_t obstacle, const std::uint16_t robot) {
  const PieceName a = e.robot_names[robot];
  const PieceName b = e.obstacle_names[obstacle];
  return {a.polygon, a.index, b.polygon, b.index};
}

NamedCollision collision_of(const Evidence& e, const std::uint32_t obstacle,
                            const std::uint16_t robot) {
  NamedCollision out;
  if (is_wall(e, obstacle))
    out.wall = e.obstacle_names[obstacle].index;
  else
    out.pair = pair_name(e, obstacle, robot);
  return out;
}

NamedTerm term_of(const planner::ScaledProblem& problem, const Evidence& e,
                  const planner::JointTerm& term) {
  NamedTerm out;
  out.of = collision_of(e, term.obstacle, term.robot);
  out.edge = {of_obstacle(term.owner), term.edge};
  out.vertex = term.vertex;
  out.weight = term.weight;
  if (is_wall(e, term.obstacle)) {
    const int exponent = problem.frame.exponent;
    const pdg::Vec2 v = problem.robot.pieces[term.robot].edges[term.vertex].vertex;
    out.wall_vertex = {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
  }
  return out;
}

NamedJoint joint_of(const planner::ScaledProblem& problem, const Evidence& e,
                    const planner::JointProof& proof) {
  NamedJoint out;
  for (const planner::PairAxes& pair : proof.pairs) {
    if (is_wall(e, pair.obstacle)) continue;  // it has one edge only
    NamedPairEdges named{pair_name(e, pair.obstacle, pair.robot), {}};
    for (const planner::PairAxes::Axis& axis : pair.axes)
      named.edges.push_back({of_obstacle(axis.owner), axis.edge});
    out.pairs.push_back(std::move(named));
  }
  for (const planner::JointSum& sum : proof.sums) {
    std::vector<NamedTerm>& terms = out.sums.emplace_back();
    for (const planner::JointTerm& term : sum) terms.push_back(term_of(problem, e, term));
  }
  return out;
}

std::vector<NamedClaim> claims_of(const planner::ScaledProblem& problem, const Evidence& e,
                                  const std::vector<planner::FullClaim>& claims) {
  std::vector<NamedClaim> out;
  out.reserve(claims.size());
  for (const planner::FullClaim& claim : claims) {
    NamedClaim& named = out.emplace_back();
    named.box = box_of(claim.box, claim.flat, problem.rotation);
    if (claim.flat != planner::kNoAxis) named.axis = claim.flat;
    if (claim.joint)
      named.joint = joint_of(problem, e, claim.proof);
    else
      named.collision = collision_of(e, claim.witness.obstacle, claim.witness.robot);
  }
  return out;
}

NamedPolygon named(const pdg::Polygon& polygon, const std::uint32_t p) {
  NamedPolygon out{p, {}};
  for (const pdg::ConvexPolygon& piece : planner::planner_pieces(polygon)) {
    Vertices& vertices = out.pieces.emplace_back();
    for (const pdg::Vec2 v : piece) vertices.push_back(point(v));
  }
  return out;
}

NamedInterval interval_of(const Evidence& e, const planner::ProvenInterval& proven) {
  NamedInterval out{proven.interval.begin, proven.interval.end, {}, {}};
  for (const planner::SeparatingEdge& edge : proven.edges)
    out.separators.push_back(
        {pair_name(e, edge.obstacle, edge.robot), {of_obstacle(edge.owner), edge.edge}});
  for (const planner::SeparatingLine& line : proven.lines)
    out.lines.push_back({pair_name(e, line.obstacle, line.robot), line.obstacle_left});
  return out;
}

void add_path(const Evidence& e, NamedEvidence& out) {
  for (const planner::Configuration& q : e.waypoints) out.waypoints.push_back({q.x, q.y, q.theta});
  for (const std::vector<planner::ProvenInterval>& segment : e.segments) {
    std::vector<NamedInterval>& intervals = out.segments.emplace_back();
    for (const planner::ProvenInterval& proven : segment)
      intervals.push_back(interval_of(e, proven));
  }
}

void add_barrier(const planner::ScaledProblem& problem, const Evidence& e, NamedEvidence& out) {
  out.domain = {point(problem.frame.origin), point(problem.domain.low), point(problem.domain.size),
                problem.frame.exponent};
  for (const planner::CellBox& box : e.barrier.start_side)
    out.start_side.push_back(box_of(planner::extent_of(box), planner::kNoAxis, problem.rotation));
  out.full = claims_of(problem, e, e.barrier.cells);
  out.full_faces = claims_of(problem, e, e.barrier.faces);
}

// `robot` is the problem of the scene's own robot, which a disc may stand for in `asked`.
void add_disc(const planner::ScaledProblem& robot, const planner::ScaledProblem& asked,
              const Evidence& e, NamedEvidence& out) {
  for (const pdg::Vec2 v : asked.given.robot.points) out.disc.push_back(point(v));
  const PieceName holder = planner::robot_names(robot.robot)[e.disc_piece];
  out.disc_holder = {holder.polygon, holder.index};
}

void add_chain(const Evidence& e, NamedEvidence& out) {
  for (const planner::ChainedSet& set : e.chain) {
    NamedCollision& named = out.chain.emplace_back();
    if (set.pair)
      named.pair = pair_name(e, set.pair->obstacle, set.pair->robot);
    else
      named.wall = set.side;
  }
}

void add_end(const Evidence& e, NamedEvidence& out) {
  out.goal_end = e.at_goal;
  out.out_of_bounds = e.out_of_bounds;
  if (!e.out_of_bounds) out.collision = collision_of(e, e.witness.obstacle, e.witness.robot);
}

void add_pieces(const planner::ScaledProblem& robot, const planner::ScaledProblem& asked,
                const Evidence& e, NamedEvidence& out) {
  for (std::uint32_t p = 0; p < robot.given.robot.size(); ++p)
    out.robot_pieces.push_back(named(robot.given.robot.polygon(p), p));
  for (const std::uint32_t p : e.polygons)
    out.obstacle_pieces.push_back(named(all_obstacles(asked).polygon(p), p));
  if (!asked.given.workspace) return;
  const planner::Rectangle r = asked.outside.bounds(0);
  out.outside = {r.low.x, r.low.y, r.high.x, r.high.y};
}

void add_claim_types(nb::module_& m) {
  nb::class_<NamedPolygon>(m, "NamedPolygon")
      .def_ro("polygon", &NamedPolygon::polygon)
      .def_ro("pieces", &NamedPolygon::pieces);
  nb::class_<NamedEdge>(m, "NamedEdge")
      .def_ro("of_obstacle", &NamedEdge::of_obstacle)
      .def_ro("edge", &NamedEdge::edge);
  nb::class_<NamedCollision>(m, "NamedCollision")
      .def_ro("pair", &NamedCollision::pair)
      .def_ro("wall", &NamedCollision::wall);
  nb::class_<NamedPairEdges>(m, "NamedPairEdges")
      .def_ro("pair", &NamedPairEdges::pair)
      .def_ro("edges", &NamedPairEdges::edges);
  nb::class_<NamedTerm>(m, "NamedTerm")
      .def_ro("of", &NamedTerm::of)
      .def_ro("edge", &NamedTerm::edge)
      .def_ro("vertex", &NamedTerm::vertex)
      .def_ro("wall_vertex", &NamedTerm::wall_vertex)
      .def_ro("weight", &NamedTerm::weight);
  nb::class_<NamedJoint>(m, "NamedJoint")
      .def_ro("pairs", &NamedJoint::pairs)
      .def_ro("sums", &NamedJoint::sums);
  nb::class_<NamedClaim>(m, "NamedClaim")
      .def_ro("box", &NamedClaim::box)
      .def_ro("axis", &NamedClaim::axis)
      .def_ro("collision", &NamedClaim::collision)
      .def_ro("joint", &NamedClaim::joint);
}

void add_path_types(nb::module_& m) {
  nb::class_<NamedSeparator>(m, "NamedSeparator")
      .def_ro("pair", &NamedSeparator::pair)
      .def_ro("edge", &NamedSeparator::edge);
  nb::class_<NamedLine>(m, "NamedLine")
      .def_ro("pair", &NamedLine::pair)
      .def_ro("obstacle_left", &NamedLine::obstacle_left);
  nb::class_<NamedInterval>(m, "NamedInterval")
      .def_ro("begin", &NamedInterval::begin)
      .def_ro("end", &NamedInterval::end)
      .def_ro("separators", &NamedInterval::separators)
      .def_ro("lines", &NamedInterval::lines);
}

}  // namespace

NamedEvidence evidence(planner::Planner& planner) {
  const nb::gil_scoped_release release;
  const Evidence e = planner.evidence();
  NamedEvidence out;
  out.kind = e.kind;
  if (e.kind == planner::ClaimKind::kNone) return out;
  const bool absent =
      e.kind == planner::ClaimKind::kDisc || e.kind == planner::ClaimKind::kSeparation;
  const planner::Planner& by = absent ? planner.planned_by() : planner;
  if (&by != &planner) out.reference = point(planner.planned_point());
  const planner::ScaledProblem& robot = by.problem();
  const planner::ScaledProblem& asked =
      e.kind == planner::ClaimKind::kDisc ? by.disc_inside().problem() : robot;
  add_pieces(robot, asked, e, out);
  if (e.kind == planner::ClaimKind::kPath) add_path(e, out);
  if (e.kind == planner::ClaimKind::kOddChain) add_chain(e, out);
  if (e.kind == planner::ClaimKind::kEnd) add_end(e, out);
  if (e.kind == planner::ClaimKind::kDisc) add_disc(robot, asked, e, out);
  if (absent) add_barrier(asked, e, out);
  return out;
}

void add_evidence(nb::module_& m) {
  nb::enum_<planner::ClaimKind>(m, "ClaimKind")
      .value("NONE", planner::ClaimKind::kNone)
      .value("PATH", planner::ClaimKind::kPath)
      .value("SEPARATION", planner::ClaimKind::kSeparation)
      .value("DISC", planner::ClaimKind::kDisc)
      .value("ODD_CHAIN", planner::ClaimKind::kOddChain)
      .value("END", planner::ClaimKind::kEnd);
  add_claim_types(m);
  add_path_types(m);
  nb::class_<NamedDomain>(m, "NamedDomain")
      .def_ro("origin", &NamedDomain::origin)
      .def_ro("low", &NamedDomain::low)
      .def_ro("size", &NamedDomain::size)
      .def_ro("exponent", &NamedDomain::exponent);
  nb::class_<NamedEvidence>(m, "NamedEvidence")
      .def_ro("kind", &NamedEvidence::kind)
      .def_ro("reference", &NamedEvidence::reference)
      .def_ro("robot_pieces", &NamedEvidence::robot_pieces)
      .def_ro("obstacle_pieces", &NamedEvidence::obstacle_pieces)
      .def_ro("outside", &NamedEvidence::outside)
      .def_ro("waypoints", &NamedEvidence::waypoints)
      .def_ro("segments", &NamedEvidence::segments)
      .def_ro("domain", &NamedEvidence::domain)
      .def_ro("start_side", &NamedEvidence::start_side)
      .def_ro("full", &NamedEvidence::full)
      .def_ro("full_faces", &NamedEvidence::full_faces)
      .def_ro("disc", &NamedEvidence::disc)
      .def_ro("disc_holder", &NamedEvidence::disc_holder)
      .def_ro("chain", &NamedEvidence::chain)
      .def_ro("goal_end", &NamedEvidence::goal_end)
      .def_ro("out_of_bounds", &NamedEvidence::out_of_bounds)
      .def_ro("collision", &NamedEvidence::collision);
}

}  // namespace bindings
