// How many of the cells in C-obstacle each C-obstacle query identifies, and what a query costs.
// Reads a scene from standard input (read_scene.hpp), writes JSON. Driven by bench/ablation.py.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

#include "misses.hpp"
#include "walk.hpp"

// One query on every cell, one after another, as often as asked. A name of its own, so that
// instruction counters can be switched on for just this.
extern "C" [[gnu::noinline]] std::size_t bench_replay(bench::World& world,
                                                      const std::vector<bench::Seen>& cells,
                                                      const bench::Query query) {
  std::size_t culled = 0;
  for (const bench::Seen& seen : cells) culled += proves(world, seen.visit, query) ? 1U : 0U;
  return culled;
}

namespace {

using namespace bench;

struct Arguments {
  bool search = false;  // the cells of our own search; otherwise level by level
  bool cover = false;   // overlapping pieces instead of disjoint ones
  Query driver = Query::kLabel;
  WalkLimits limits;
  std::size_t repeats = 5;
  std::size_t misses = 400;   // at most so many are looked into
  std::optional<Query> only;  // replay this query once, nothing else: for instruction counters
};

Query query_named(const std::string& name) {
  for (std::size_t q = 0; q < kQueries; ++q)
    if (name == kQueryNames[q]) return static_cast<Query>(q);
  throw std::runtime_error("no query is called " + name);
}

Arguments parse(const int count, char** const words) {
  Arguments out;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--search") {
      out.search = true;
    } else if (word == "--cover") {
      out.cover = true;
    } else if (i + 1 == count) {
      throw std::runtime_error("what is the value of " + word + "?");
    } else if (word == "--only") {
      out.only = query_named(words[++i]);
      out.limits.truth = false;
    } else if (word == "--driver") {
      out.driver = query_named(words[++i]);
    } else if (word == "--cells") {
      out.limits.cells = std::stoul(words[++i]);
    } else if (word == "--budget") {
      out.limits.budget = std::stoul(words[++i]);
    } else if (word == "--repeats") {
      out.repeats = std::stoul(words[++i]);
    } else if (word == "--misses") {
      out.misses = std::stoul(words[++i]);
    } else {
      throw std::runtime_error("what is " + word + "?");
    }
  }
  return out;
}

struct Census {
  std::size_t cells = 0, obstacle = 0, undecided = 0;
  std::array<std::size_t, kQueries> culled{};
};

void add(Census& census, const Seen& seen) {
  ++census.cells;
  census.obstacle += seen.truth == Truth::kObstacle ? 1U : 0U;
  census.undecided += seen.truth == Truth::kUndecided ? 1U : 0U;
  for (std::size_t q = 0; q < kQueries; ++q) census.culled[q] += seen.culled[q] ? 1U : 0U;
}

void print(const Census& census) {
  std::printf("{\"cells\": %zu, \"obstacle\": %zu, \"undecided\": %zu, \"culled\": {", census.cells,
              census.obstacle, census.undecided);
  for (std::size_t q = 0; q < kQueries; ++q)
    std::printf("%s\"%s\": %zu", q == 0 ? "" : ", ", kQueryNames[q], census.culled[q]);
  std::printf("}}");
}

// Processor seconds of one pass over the cells, `repeats` times: what else runs on the machine
// counts less than on a wall clock.
std::vector<double> timed(World& world, const std::vector<Seen>& cells, const Query query,
                          const std::size_t repeats) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i < repeats; ++i) {
    const std::clock_t begin = std::clock();
    bench_replay(world, cells, query);
    seconds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return seconds;
}

void print_costs(World& world, const std::vector<Seen>& cells, const std::size_t repeats) {
  std::printf(", \"costs\": {");
  for (std::size_t q = 0; q < kQueries; ++q) {
    const auto query = static_cast<Query>(q);
    const std::uint64_t before = world.statistics.separation_evaluations;
    bench_replay(world, cells, query);  // warm, and counted
    const std::uint64_t evaluations = world.statistics.separation_evaluations - before;
    std::printf("%s\"%s\": {\"evaluations\": %llu, \"seconds\": [", q == 0 ? "" : ", ",
                kQueryNames[q], static_cast<unsigned long long>(evaluations));
    const std::vector<double> seconds = timed(world, cells, query, repeats);
    for (std::size_t i = 0; i < seconds.size(); ++i)
      std::printf("%s%.6e", i == 0 ? "" : ", ", seconds[i]);
    std::printf("]}");
  }
  std::printf("}");
}

// Every k-th missed cell, so that those looked into are spread over all levels.
Misses look_into(World& world, const std::vector<Seen>& cells, const std::size_t most) {
  std::vector<const Seen*> missed;
  for (const Seen& seen : cells)
    if (seen.truth == Truth::kObstacle && !seen.culled[static_cast<std::size_t>(Query::kLabel)])
      missed.push_back(&seen);
  Misses misses;
  const std::size_t step = most == 0 ? 0 : std::max<std::size_t>(1, missed.size() / most);
  for (std::size_t i = 0; step != 0 && i < missed.size(); i += step)
    classify(world, *missed[i], misses);
  return misses;
}

void report(World& world, const std::vector<Seen>& cells, const Arguments& arguments) {
  Census whole;
  std::vector<Census> levels;
  for (const Seen& seen : cells) {
    add(whole, seen);
    levels.resize(std::max(levels.size(), static_cast<std::size_t>(seen.level) + 1));
    add(levels[static_cast<std::size_t>(seen.level)], seen);
  }
  std::printf("{\"total\": ");
  print(whole);
  std::printf(", \"levels\": [");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (i > 0) std::printf(", ");
    print(levels[i]);
  }
  std::printf("]");
  const Misses misses = look_into(world, cells, arguments.misses);
  std::printf(", \"misses\": {\"closed\": %zu, \"slack\": %zu, \"several\": %zu, \"unclear\": %zu}",
              misses.closed, misses.slack, misses.several, misses.unclear);
  print_costs(world, cells, arguments.repeats);
  std::printf("}\n");
}

void run(const Arguments& arguments) {
  Task task = read_task(std::cin);
  planner::Ablation ablation;
  ablation.partition = !arguments.cover;
  World world(task.scene, ablation, task.start.theta);
  const std::vector<Seen> cells = arguments.search
                                      ? walk_search(world, task, arguments.limits)
                                      : walk_levels(world, arguments.driver, arguments.limits);
  if (arguments.only) {
    const std::size_t culled = bench_replay(world, cells, *arguments.only);
    std::printf("{\"cells\": %zu, \"culled\": %zu}\n", cells.size(), culled);
    return;
  }
  report(world, cells, arguments);
}

}  // namespace

int main(const int count, char** const words) {
  try {
    run(parse(count, words));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "culling: %s\n", error.what());
    return 1;
  }
  return 0;
}
