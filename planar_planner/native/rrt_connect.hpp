// Two rapidly exploring random trees grown towards each other (Kuffner & LaValle, ICRA 2000): a
// quick first try, for scenes with room. What it finds is a guess that has to be certified; what it
// does not find proves nothing. Its random numbers are fixed, its limit is a count.
#pragma once

#include <cstdint>
#include <vector>

#include "collision.hpp"
#include "limits.hpp"

namespace planner {

// Of the random numbers: of 1 to 40, one of those that solve most of the shipped scenes soon.
// Another would do as well elsewhere.
inline constexpr std::uint64_t kSeed = 37;

class RrtConnect {
 public:
  // May ask `hint` about so many configurations, as long as that is not more work than this.
  RrtConnect(const Problem& problem, CollisionHint& hint, std::int64_t budget,
             std::uint64_t most_work = UINT64_MAX)
      : problem_(problem), hint_(hint), budget_(budget), most_work_(most_work) {}

  // Waypoints from start to goal, theta running on; asked about at most `spacing` apart (planner
  // units, a turn counting as its longest way). Empty if the budget is spent or the terminator
  // strikes.
  std::vector<Configuration> find(const Configuration& start, const Configuration& goal,
                                  double spacing, const Terminator& stop);

 private:
  struct Node {
    Pose pose;  // theta within half a turn of zero
    std::uint32_t parent = 0;
  };
  using Tree = std::vector<Node>;
  enum class Advance : std::uint8_t { kTrapped, kAdvanced, kReached };

  [[nodiscard]] bool spent() const { return budget_ <= 0 || hint_.work() >= most_work_; }
  Advance extend(Tree& tree, const Pose& target);
  Advance connect(Tree& tree, const Pose& target);
  Advance step(Tree& tree, std::uint32_t from, const Pose& target);
  std::uint32_t nearest(const Tree& tree, const Pose& target);
  bool passes(const Pose& from, const Pose& to);
  [[nodiscard]] Pose towards(const Pose& from, const Pose& to, double s) const;
  [[nodiscard]] double squared_distance(const Pose& a, const Pose& b) const;
  Pose sample();
  double random();
  [[nodiscard]] std::vector<Configuration> joined(const Tree& from_start, const Tree& from_goal,
                                                  const Configuration& start,
                                                  const Configuration& goal) const;

  const Problem& problem_;
  CollisionHint& hint_;
  std::int64_t budget_;
  std::uint64_t most_work_;
  double spacing_ = 0.0;
  double range_ = 0.0;  // longest edge
  double theta_ = 0.0;  // of every configuration where the robot cannot turn
  std::uint64_t state_ = kSeed;
  std::vector<std::uint64_t> middles_, next_;  // of passes: what is still to be asked
};

}  // namespace planner
