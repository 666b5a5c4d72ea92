// Re-evaluates the core's predicates in ball arithmetic and counts false labels; CSV on stdout.
// Fails if there is one, or if an error exceeds its bound. Built without margins (--expect-false)
// it fails if an adversarial family that leans on them is not caught.
//
// Usage: rounding [--random N] [--adversarial N] [--seed S] [--family NAME]... [--expect-false]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include "families.hpp"

namespace {

using rounding::Request;
using rounding::Tally;
using Family = std::vector<Tally> (*)(const Request&);

constexpr std::pair<const char*, Family> kFamilies[] = {
    {"pairs", rounding::pairs},           {"segments", rounding::segments},
    {"bounds", rounding::bounds},         {"scenes", rounding::scenes},
    {"placements", rounding::placements}, {"depths", rounding::depths},
    {"queries", rounding::queries},       {"distances", rounding::distances},
    {"brackets", rounding::brackets},     {"sets", rounding::sets},
};

struct Options {
  std::uint64_t random = 20000;
  std::uint64_t adversarial = 5000;
  std::uint64_t seed = 1;
  std::vector<std::string> families;
  bool expect_false = false;
};

bool parse(const int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--expect-false") {
      options.expect_false = true;
      continue;
    }
    if (++i == argc) return false;
    if (name == "--family") {
      options.families.emplace_back(argv[i]);
      continue;
    }
    std::uint64_t* const number = name == "--random"        ? &options.random
                                  : name == "--adversarial" ? &options.adversarial
                                  : name == "--seed"        ? &options.seed
                                                            : nullptr;
    char* end = nullptr;
    if (number == nullptr) return false;
    *number = std::strtoull(argv[i], &end, 10);
    if (*end != '\0') return false;
  }
  return true;
}

bool wanted(const Options& options, const char* name) {
  for (const std::string& family : options.families)
    if (family == name) return true;
  return options.families.empty();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fprintf(stderr, "usage: %s [--random N] [--adversarial N] [--seed S] [--family NAME]...\n",
                 argv[0]);
    return 2;
  }
  bool good = true;
  std::printf("family,kind,inputs,claims,false_labels,values,largest_error_over_bound\n");
  for (const auto& [name, run] : kFamilies) {
    if (!wanted(options, name)) continue;
    for (const bool adversarial : {false, true}) {
      if (adversarial ? options.adversarial == 0 : options.random == 0) continue;
      const Request request{adversarial ? options.adversarial : options.random,
                            2 * options.seed + (adversarial ? 1 : 0), adversarial};
      for (const Tally& t : run(request)) {
        std::printf("%s,%s,%llu,%llu,%llu,%llu,%.4f\n", t.family.c_str(),
                    adversarial ? "adversarial" : "random",
                    static_cast<unsigned long long>(t.inputs),
                    static_cast<unsigned long long>(t.claims),
                    static_cast<unsigned long long>(t.false_ones),
                    static_cast<unsigned long long>(t.values), t.tightness);
        std::fflush(stdout);
        if (options.expect_false)
          good = good && (!adversarial || !t.leans_on_margin || t.false_ones > 0);
        else
          good = good && t.false_ones == 0 && t.tightness <= 1.0;
      }
    }
  }
  return good ? 0 : 1;
}
