// Solves the scenes on stdin and prints a hash of each answer: verdict, counts and the path's
// doubles, bit for bit. Written by tests/attacks/determinism.py, which builds it with several
// compilers.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "planar_planner/native/planning/planner.hpp"

namespace {

using planner::Configuration;
using planner::Vec2;

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "determinism: bad input: %s\n", what);
  std::exit(2);
}

double number() {
  double x = 0.0;
  if (std::scanf("%la", &x) != 1) fail("number");
  return x;
}

std::size_t count() {
  unsigned long n = 0;
  if (std::scanf("%lu", &n) != 1) fail("count");
  return n;
}

Vec2 point() {
  const double x = number();
  return {x, number()};
}

planner::PolygonSet polygons() {
  planner::PolygonSet set;
  for (std::size_t n = count(); n > 0; --n) {
    planner::Polygon polygon;
    for (std::size_t rings = count(); rings > 0; --rings) {
      pdg::Ring ring;
      for (std::size_t points = count(); points > 0; --points) ring.push_back(point());
      polygon.rings.push_back(ring);
    }
    set.append(polygon);
  }
  return set;
}

std::optional<planner::Rectangle> rectangle() {
  if (count() == 0) return std::nullopt;
  const Vec2 low = point();
  return planner::Rectangle{low, point()};
}

Configuration configuration() {
  const Vec2 t = point();
  return {t.x, t.y, number()};
}

planner::Goal goal() {
  if (count() == 0) return configuration();
  planner::GoalSet set;
  set.polygons = polygons();
  if (count() == 1) {
    const double low = number();
    set.angles = {low, number()};
  }
  return set;
}

// Fowler, Noll and Vo's hash of the bytes.
class Hash {
 public:
  void add(const std::uint64_t word) {
    for (unsigned shift = 0; shift < 64; shift += 8) {
      value_ ^= word >> shift & 0xffU;
      value_ *= 0x100000001b3U;
    }
  }
  void add(const double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const std::string& text) {
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

// What the core called it before it had DecidedBy and StopReason, so that hashes can be compared.
std::string sentence(const planner::Answer& answer) {
  if (answer.verdict == planner::Verdict::kUndecided) {
    switch (answer.stop_reason.value()) {
      case planner::StopReason::kResolution:
        return "resolution reached";
      case planner::StopReason::kMaxCells:
        return "cell limit reached";
      default:
        fail("an answer that depends on the machine");
    }
  }
  switch (answer.statistics.decided_by.value()) {
    case planner::DecidedBy::kChannel:
      return "certified through a channel of cells";
    case planner::DecidedBy::kRidge:
      return "certified along the ridge of the clearance";
    case planner::DecidedBy::kSeparation:
      return "cells and faces proven to lie in C-obstacle separate start from goal";
    case planner::DecidedBy::kDisc:
      if (answer.verdict == planner::Verdict::kNoPath) return "a disc inside the robot has no path";
      [[fallthrough]];
    default:
      return "certified " + std::string(planner::word(*answer.statistics.decided_by));
  }
}

std::uint64_t hash_of(planner::Planner& planner, const planner::Answer& answer) {
  Hash hash;
  const planner::Statistics& s = answer.statistics;
  hash.add(static_cast<std::uint64_t>(answer.verdict));
  hash.add(sentence(answer));
  if (s.decided_by) hash.add(std::string(planner::word(*s.decided_by)));
#define HASH_Work(name) hash.add(s.name);
#define HASH_Count(name)
#define HASH_LabelCounts(name)
#define HASH_LevelCounts(name)
#define HASH_Bytes(name)
#define HASH_Seconds(name)
#define HASH_Real(name)
#define HASH_Decision(name)
#define HASH(type, name, adding, unit, meaning) HASH_##type(name)
  PLANNER_STATISTICS(HASH)
  for (const std::uint64_t n : s.cells_by_label.of) hash.add(n);
  for (const std::uint64_t n : s.cells_by_level) hash.add(n);
  for (const double x : {answer.path.length, answer.path.turning, planner.least_clearance()})
    hash.add(x);
  for (const Configuration& q : answer.path.waypoints)
    for (const double x : {q.x, q.y, q.theta}) hash.add(x);
  return hash.value();
}

}  // namespace

int main() {
  const std::uint64_t max_cells = count();
  for (std::size_t scenes = count(); scenes > 0; --scenes) {
    char name[256];
    if (std::scanf("%255s", name) != 1) fail("name");
    planner::Problem scene;
    scene.rotation = count() == 1;
    scene.robot = polygons();
    scene.obstacles = polygons();
    scene.box = rectangle();
    const planner::PolygonSet workspace = polygons();
    if (workspace.size() == 1) scene.workspace = workspace.polygon(0);
    scene.reference_bounds = rectangle();
    const Configuration start = configuration();
    const planner::Goal end = goal();
    planner::Limits limits;
    limits.max_cells = max_cells;
    limits.timeout = std::numeric_limits<double>::infinity();
    limits.max_memory = std::numeric_limits<std::uint64_t>::max();
    planner::Planner planner(std::move(scene));
    const planner::Answer answer = planner.solve(start, end, limits, {});
    constexpr const char* verdicts[] = {"path", "no_path", "undecided"};
    std::printf("%s %s %016llx\n", name, verdicts[static_cast<std::size_t>(answer.verdict)],
                static_cast<unsigned long long>(hash_of(planner, answer)));
  }
}
