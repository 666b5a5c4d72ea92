// Solves the scenes on stdin and prints a hash of each answer: verdict, counts and the path's
// doubles, bit for bit. Written by tests/attacks/determinism.py, which builds it with several compilers.
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

std::uint64_t hash_of(planner::Planner& planner, const planner::Answer& answer) {
  Hash hash;
  const planner::Statistics& s = answer.statistics;
  hash.add(static_cast<std::uint64_t>(answer.verdict));
  hash.add(answer.reason);
  hash.add(s.decided_by);
  for (const std::uint64_t n :
       {s.labelled_cells, s.separation_evaluations, s.pairs_touched, s.pairs_total, s.star_tests,
        s.joint_cells, s.faces_tested, s.segments_tested, s.probe_checks, s.ridge_tries,
        s.ridge_evaluations, s.search_rounds, s.search_expansions, s.search_rebuilds,
        s.channel_length})
    hash.add(n);
  for (const std::uint64_t n : answer.cells_by_label) hash.add(n);
  for (const std::uint64_t n : answer.cells_by_level) hash.add(n);
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
    planner::Scene scene;
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
