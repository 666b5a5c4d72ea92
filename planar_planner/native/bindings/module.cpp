// Thin bindings of the planner's core: plain arrays, tuples and dictionaries in and out. Input has
// been validated by planar_planner.problem; nothing is checked again here.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "build.hpp"
#include "cells.hpp"
#include "evidence.hpp"
#include "outcome.hpp"
#include "planar_planner/native/planning/planner.hpp"
#include "state_check.hpp"
#include "statistics.hpp"
#include "wall.hpp"

namespace nb = nanobind;

namespace {

using planner::Configuration;
using planner::PolygonSet;
using planner::Rectangle;

using Points = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using Starts = nb::ndarray<const std::uint32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Path = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using PolygonArrays = std::tuple<Points, Starts, Starts>;
using Box = std::array<double, 4>;
// A configuration, or polygons and the two ends of an interval of theta.
using GoalArrays = std::variant<std::array<double, 3>,
                                std::tuple<PolygonArrays, std::optional<std::array<double, 2>>>>;

PolygonSet polygons(const PolygonArrays& arrays) {
  const auto& [points, rings, starts] = arrays;
  PolygonSet out;
  out.points.resize(points.shape(0));
  for (std::size_t i = 0; i < points.shape(0); ++i)
    out.points[i] = {points.data()[2 * i], points.data()[2 * i + 1]};
  out.ring_starts.assign(rings.data(), rings.data() + rings.shape(0));
  out.polygon_starts.assign(starts.data(), starts.data() + starts.shape(0));
  return out;
}

std::optional<Rectangle> rectangle(const std::optional<Box>& box) {
  if (!box) return std::nullopt;
  return Rectangle{{(*box)[0], (*box)[1]}, {(*box)[2], (*box)[3]}};
}

Configuration configuration(const std::array<double, 3>& q) {
  return {q[0], q[1], q[2]};
}

planner::Goal goal_of(const GoalArrays& arrays) {
  if (const auto* const q = std::get_if<std::array<double, 3>>(&arrays)) return configuration(*q);
  const auto& [region, angles] = std::get<1>(arrays);
  planner::GoalSet set;
  set.polygons = polygons(region);
  if (angles) set.angles = {(*angles)[0], (*angles)[1]};
  return set;
}

planner::Problem problem_of(const PolygonArrays& robot, const PolygonArrays& obstacles,
                            const std::optional<Box>& box,
                            const std::optional<PolygonArrays>& workspace,
                            const std::optional<Box>& reference_bounds, const bool rotation) {
  planner::Problem scene;
  scene.robot = polygons(robot);
  scene.obstacles = polygons(obstacles);
  scene.box = rectangle(box);
  if (workspace) scene.workspace = polygons(*workspace).polygon(0);
  scene.reference_bounds = rectangle(reference_bounds);
  scene.rotation = rotation;
  return scene;
}

[[noreturn]] void refuse(const char* what, const std::string& name, const std::string& known) {
  throw nb::value_error(
      ("there is no " + std::string(what) + " " + name + "; known are" + known).c_str());
}

void leave_out(planner::Ablation& ablation, const std::string& part) {
#define PLANNER_LEAVE_OUT(name) \
  if (part == #name) {          \
    ablation.name = false;      \
    return;                     \
  }
#define PLANNER_KNOWN(name) " " #name
  PLANNER_PARTS(PLANNER_LEAVE_OUT)
  refuse("part", part, PLANNER_PARTS(PLANNER_KNOWN));
#undef PLANNER_LEAVE_OUT
#undef PLANNER_KNOWN
}

planner::CullingQuery query_of(const std::string& query) {
#define PLANNER_RETURN(enumerator, name) \
  if (query == name) return planner::CullingQuery::enumerator;
#define PLANNER_KNOWN(enumerator, name) " " name
  PLANNER_CULLING_QUERIES(PLANNER_RETURN)
  refuse("query", query, PLANNER_CULLING_QUERIES(PLANNER_KNOWN));
#undef PLANNER_RETURN
#undef PLANNER_KNOWN
}

// Without some parts, for benchmarks.
planner::Ablation ablation_of(const std::vector<std::string>& without, const std::string& query) {
  planner::Ablation ablation;
  for (const std::string& part : without) leave_out(ablation, part);
  ablation.query = query_of(query);
  return ablation;
}

nb::dict placement_dict(const planner::Placement& p) {
  constexpr std::array<const char*, 4> states{"free", "contact", "colliding", "outside"};
  nb::dict out;
  out["state"] = states[static_cast<std::size_t>(p.state)];
  const char* what = p.wall ? "workspace" : "obstacle";
  if (p.state == planner::PlacementState::kFree) what = "";
  if (p.state == planner::PlacementState::kOutside) what = "reference_bounds";
  out["what"] = what;
  out["polygon"] = p.obstacle;
  out["piece"] = p.robot_polygon;
  out["exact"] = p.exact;
  out["depth"] = p.depth;
  out["separation"] = p.clearance;
  return out;
}

nb::object path_array(const std::vector<Configuration>& path) {
  auto data = std::make_unique<double[]>(3 * path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    data[3 * i] = path[i].x;
    data[3 * i + 1] = path[i].y;
    data[3 * i + 2] = path[i].theta;
  }
  double* const raw = data.get();
  nb::capsule owner(data.release(), [](void* p) noexcept {
    const std::unique_ptr<double[]> reclaim(static_cast<double*>(p));
  });
  return nb::ndarray<nb::numpy, double, nb::ndim<2>>(raw, {path.size(), 3}, owner).cast();
}

// Runs Python's signal handlers, then the caller's listener; false on Ctrl-C or on its wish.
bool ask_python(const nb::object& listener, const planner::Progress& p) {
  const nb::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) {
    if (!PyErr_ExceptionMatches(PyExc_KeyboardInterrupt)) nb::raise_python_error();
    PyErr_Clear();
    return false;
  }
  if (listener.is_none()) return true;
  nb::dict counts;
  counts["elapsed"] = p.elapsed;
  counts["cells"] = p.cells;
  counts["free"] = p.free;
  counts["star"] = p.star;
  counts["full"] = p.full;
  counts["mixed"] = p.mixed;
  counts["channel_length"] = p.channel_length;
  counts["rounds"] = p.rounds;
  try {
    return nb::cast<bool>(listener(counts));
  } catch (nb::python_error& error) {
    if (!error.matches(PyExc_KeyboardInterrupt)) throw;
    return false;
  }
}

nb::dict solve(planner::Planner& planner, const std::array<double, 3>& start,
               const GoalArrays& goal, const double resolution, const std::uint64_t max_cells,
               const double timeout, const std::uint64_t max_memory, const double contact_tolerance,
               const nb::object& listener) {
  const planner::Limits limits{resolution, max_cells, timeout, max_memory, contact_tolerance};
  const planner::Listener ask = [&](const planner::Progress& p) { return ask_python(listener, p); };
  const planner::Goal to = goal_of(goal);
  planner::Answer answer;
  {
    const nb::gil_scoped_release release;
    answer = planner.solve_certified(configuration(start), to, limits, ask);
  }
  constexpr std::array<const char*, 3> verdicts{"path", "no_path", "undecided"};
  nb::dict out;
  out["verdict"] = verdicts[static_cast<std::size_t>(answer.verdict)];
  out["stop_reason"] = answer.stop_reason;
  out["ends_moved"] = answer.ends_moved;
  out["to_be_checked"] = answer.to_be_checked;
  out["exact_legs"] = !answer.exact.empty();
  out["path"] = path_array(answer.path.waypoints);
  out["stats"] = answer.statistics;
  return out;
}

nb::dict check_path(planner::Planner& planner, const Path& path) {
  std::vector<Configuration> waypoints(path.shape(0));
  for (std::size_t i = 0; i < waypoints.size(); ++i)
    waypoints[i] = {path.data()[3 * i], path.data()[3 * i + 1], path.data()[3 * i + 2]};
  const nb::gil_scoped_release release;
  const planner::PathCheck check = planner.check_path(std::move(waypoints));
  const nb::gil_scoped_acquire acquire;
  nb::dict out;
  out["valid"] = check.bad_segment < 0;
  out["segment"] = check.bad_segment;
  out["least_clearance"] = check.least_clearance;
  return out;
}

}  // namespace

NB_MODULE(_core, m) {
  // An object that the interpreter still holds when it ends is no fault worth a message.
  nanobind::set_leak_warnings(false);
  m.doc() = "Native core of planar_planner; see planar_planner for the public interface.";
  bindings::add_evidence(m);
  nb::class_<planner::Planner>(m, "Core")
      .def(
          "__init__",
          [](planner::Planner* self, const PolygonArrays& robot, const PolygonArrays& obstacles,
             const std::optional<Box>& workspace_box, const std::optional<PolygonArrays>& workspace,
             const std::optional<Box>& reference_bounds, const bool rotation,
             const std::vector<std::string>& without, const std::string& query) {
            new (self) planner::Planner(
                problem_of(robot, obstacles, workspace_box, workspace, reference_bounds, rotation),
                ablation_of(without, query));
          },
          nb::arg("robot"), nb::arg("obstacles"), nb::arg("workspace_box").none(),
          nb::arg("workspace").none(), nb::arg("reference_bounds").none(), nb::arg("rotation"),
          nb::arg("without") = std::vector<std::string>{}, nb::arg("query") = "per-normal")
      .def("tolerated_error", &planner::Planner::tolerated_error)
      .def(
          "placement",
          [](planner::Planner& self, const std::array<double, 3>& q) {
            return placement_dict(self.placement(configuration(q)));
          },
          nb::arg("q"))
      .def("solve", &solve, nb::arg("start"), nb::arg("goal"), nb::arg("resolution"),
           nb::arg("max_cells"), nb::arg("timeout"), nb::arg("max_memory"),
           nb::arg("contact_tolerance"), nb::arg("listener").none())
      .def("check_path", &check_path, nb::arg("path"))
      .def("least_clearance", &planner::Planner::least_clearance,
           nb::call_guard<nb::gil_scoped_release>())
      .def("evidence", &bindings::evidence)
      .def("cells", &bindings::cells)
      .def("thinnest_wall", &bindings::thinnest_wall)
      .def("wall", &bindings::wall, nb::arg("theta"));
  m.def("build_info", &bindings::build_info);
  bindings::add_outcome(m);
  nb::class_<planner::Limits>(m, "Limits", "The default limits of a query.")
      .def(nb::init<>())
      .def_ro("resolution", &planner::Limits::resolution)
      .def_ro("max_cells", &planner::Limits::max_cells)
      .def_ro("timeout", &planner::Limits::timeout)
      .def_ro("max_memory", &planner::Limits::max_memory)
      .def_ro("contact_tolerance", &planner::Limits::contact_tolerance);
  bindings::add_statistics(m);
  bindings::add_state_check(m);
}
