// One run of one of OMPL's planners on a dumped problem (bench/parts/ompl/driver.py), with the
// core's state check called directly: ompl_native FILE PLANNER SEED LIMIT RESOLUTION prints one
// JSON line. Preparation and solve are timed apart, the clock running on from the first to the
// second.
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "planar_planner/native/paths/state_check.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using planner::Configuration;
using planner::StateCheck;
using Clock = std::chrono::steady_clock;

// Seconds at most of a first, untimed run: this process is new, whereas ours is timed in one that
// has answered the query before. Loading code and touching memory are in neither's time.
constexpr double kWarmUp = 0.05;

struct Query {
  planner::Problem scene;
  Configuration start, goal;
};

template <class T>
T next(std::istream& in) {
  T value;
  if (!(in >> value)) throw std::runtime_error("the dump ends early or holds no number");
  return value;
}

Configuration read_configuration(std::istream& in) {
  const auto x = next<double>(in);
  const auto y = next<double>(in);
  return {x, y, next<double>(in)};
}

std::optional<planner::Rectangle> read_rectangle(std::istream& in) {
  if (next<int>(in) == 0) return std::nullopt;
  std::array<double, 4> v{};
  for (double& each : v) each = next<double>(in);
  return planner::Rectangle{{v[0], v[1]}, {v[2], v[3]}};
}

planner::PolygonSet read_polygons(std::istream& in) {
  planner::PolygonSet set;
  set.points.resize(next<std::size_t>(in));
  for (pdg::Vec2& p : set.points) {
    p.x = next<double>(in);
    p.y = next<double>(in);
  }
  for (std::vector<std::uint32_t>* const starts : {&set.ring_starts, &set.polygon_starts}) {
    starts->resize(next<std::size_t>(in));
    for (std::uint32_t& each : *starts) each = next<std::uint32_t>(in);
  }
  return set;
}

// In the order in which bench/parts/ompl/driver.py writes.
Query read_query(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file);
  Query query;
  planner::Problem& scene = query.scene;
  scene.rotation = next<int>(in) != 0;
  query.start = read_configuration(in);
  query.goal = read_configuration(in);
  scene.box = read_rectangle(in);
  scene.reference_bounds = read_rectangle(in);
  scene.robot = read_polygons(in);
  scene.obstacles = read_polygons(in);
  if (next<int>(in) != 0) scene.workspace = read_polygons(in).polygon(0);
  return query;
}

// States of SE2, or of the plane at the start's theta.
struct States {
  bool turning;
  double theta;

  [[nodiscard]] Configuration read(const ob::State* state) const {
    if (!turning) {
      const auto* s = state->as<ob::RealVectorStateSpace::StateType>();
      return {s->values[0], s->values[1], theta};
    }
    const auto* s = state->as<ob::SE2StateSpace::StateType>();
    return {s->getX(), s->getY(), s->getYaw()};
  }
  void write(const Configuration& q, ob::State* state) const {
    if (!turning) {
      auto* s = state->as<ob::RealVectorStateSpace::StateType>();
      s->values[0] = q.x;
      s->values[1] = q.y;
      return;
    }
    auto* s = state->as<ob::SE2StateSpace::StateType>();
    s->setXY(q.x, q.y);
    s->setYaw(q.theta);
  }
};

ob::StateSpacePtr make_space(const StateCheck& check, const bool turning) {
  ob::RealVectorBounds bounds(2);
  const planner::Rectangle r = check.bounds();
  bounds.low = {r.low.x, r.low.y};
  bounds.high = {r.high.x, r.high.y};
  if (!turning) {
    const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(bounds);
    return plane;
  }
  const auto space = std::make_shared<ob::SE2StateSpace>();
  space->setBounds(bounds);
  space->setSubspaceWeight(1, check.robot_radius());
  return space;
}

ob::PlannerPtr make_planner(const std::string& name, const ob::SpaceInformationPtr& information) {
  if (name == "RRTConnect") return std::make_shared<og::RRTConnect>(information);
  if (name == "PRM") return std::make_shared<og::PRM>(information);
  if (name == "KPIECE1") return std::make_shared<og::KPIECE1>(information);
  if (name == "EST") return std::make_shared<og::EST>(information);
  throw std::runtime_error("unknown planner " + name);
}

double seconds(const Clock::time_point begin, const Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

// The cost of one check on random states of the bounds, in nanoseconds.
double cost_of_check(StateCheck& check, const States& states) {
  constexpr int count = 20000;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const planner::Rectangle r = check.bounds();
  std::vector<Configuration> places(count);
  for (Configuration& q : places)
    q = {r.low.x + unit(random) * (r.high.x - r.low.x),
         r.low.y + unit(random) * (r.high.y - r.low.y),
         states.turning ? (2.0 * unit(random) - 1.0) * std::numbers::pi : states.theta};
  const Clock::time_point begin = Clock::now();
  for (const Configuration& q : places) check.is_free(q);
  return 1e9 * seconds(begin, Clock::now()) / count;
}

// One run. Times in seconds: preparing is from the scene's polygons in memory until the planner is
// made, solving the planner's setup and solve.
struct Attempt {
  States states{};
  std::unique_ptr<StateCheck> check;
  ob::ProblemDefinitionPtr definition;
  double preparing = 0.0;
  double solving = 0.0;
  std::uint64_t checks = 0;
};

Attempt attempt(Query query, const std::string& name, const double limit, const double resolution) {
  Attempt made;
  const States states{query.scene.rotation, query.start.theta};
  made.states = states;
  const Clock::time_point begin = Clock::now();
  made.check = std::make_unique<StateCheck>(planner::make_scaled_problem(std::move(query.scene)));
  StateCheck& check = *made.check;
  const auto information =
      std::make_shared<ob::SpaceInformation>(make_space(check, states.turning));
  information->setStateValidityChecker(
      [&check, states](const ob::State* state) { return check.is_free(states.read(state)); });
  information->setStateValidityCheckingResolution(resolution);
  information->setup();
  made.definition = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<> start(information);
  ob::ScopedState<> goal(information);
  states.write(query.start, start.get());
  states.write(query.goal, goal.get());
  information->enforceBounds(start.get());
  information->enforceBounds(goal.get());
  made.definition->setStartAndGoalStates(start, goal);
  const ob::PlannerPtr planner = make_planner(name, information);
  const std::uint64_t before = check.checks();
  const Clock::time_point prepared = Clock::now();
  planner->setProblemDefinition(made.definition);
  planner->setup();
  planner->solve(
      ob::plannerOrTerminationCondition(ob::timedPlannerTerminationCondition(limit),
                                        ob::exactSolnPlannerTerminationCondition(made.definition)));
  const Clock::time_point end = Clock::now();
  made.preparing = seconds(begin, prepared);
  made.solving = seconds(prepared, end);
  made.checks = check.checks() - before;
  return made;
}

void print(const Attempt& made) {
  const ob::ProblemDefinitionPtr& definition = made.definition;
  const bool exact = definition->hasExactSolution();
  const double check_ns = cost_of_check(*made.check, made.states);
  std::printf(R"({"exact": %s, "prepare_seconds": %.9g, "seconds": %.9g, "checks": %llu, )",
              exact ? "true" : "false", made.preparing, made.solving,
              static_cast<unsigned long long>(made.checks));
  std::printf(R"("check_ns": %.4g, )", check_ns);
  std::printf(R"("native_check_ns": %.4g, "ompl": "%s", "path": [)", check_ns, OMPL_NATIVE_VERSION);
  if (exact) {
    const char* separator = "";
    for (const ob::State* state :
         definition->getSolutionPath()->as<og::PathGeometric>()->getStates()) {
      const Configuration q = made.states.read(state);
      std::printf("%s[%.17g, %.17g, %.17g]", separator, q.x, q.y, q.theta);
      separator = ", ";
    }
  }
  std::printf("]}\n");
}

void run(const std::string& file, const std::string& name, const unsigned long seed,
         const double limit, const double resolution) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const Query query = read_query(file);
  const auto once = [&](const double time) {
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed));
    return attempt(query, name, time, resolution);
  };
  once(std::min(limit, kWarmUp));
  print(once(limit));
}

}  // namespace

int main(const int count, const char* const* const arguments) {
  try {
    const std::vector<std::string> given(arguments, arguments + count);
    if (count != 6)
      throw std::runtime_error("usage: ompl_native FILE PLANNER SEED LIMIT RESOLUTION");
    run(given[1], given[2], std::stoul(given[3]), std::stod(given[4]), std::stod(given[5]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ompl_native: %s\n", error.what());
    return 2;
  }
  return 0;
}
