// The set of goal configurations: what lies in it, decided exactly; which cells may meet it,
// decided on the safe side; and guesses at configurations of it for the search.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dyadic_box.hpp"
#include "planar_planner/native/world/problem.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

class GoalRegion {
 public:
  // The problem must outlive the region.
  GoalRegion(const ScaledProblem& problem, const GoalSet& set);

  // Exactly, for the doubles as they are; theta as the interval writes it, without whole turns.
  [[nodiscard]] bool contains(const Configuration& q) const;

  // False: no configuration of the closed box, an exact part of the domain, is a goal. True as well
  // where rounding cannot tell.
  [[nodiscard]] bool may_meet(const CellSpace& space, const CellBox& box) const;

  // Guesses. All of them are contained; whether they are free is another question.
  // Configurations of the box, well inside first; may be empty where rounding cannot find any.
  [[nodiscard]] std::vector<Configuration> inside(const CellSpace& space, const CellBox& box) const;
  // The nearest ones of some parts of the region, and middles of parts, the nearest first.
  [[nodiscard]] std::vector<Configuration> near(const Configuration& q) const;
  // From three numbers in [0, 1), uniform in the part of the region that is in the domain.
  [[nodiscard]] std::optional<Configuration> sample(double u, double v, double w) const;
  // The angle nearest to theta that is a goal's, as the interval writes it.
  [[nodiscard]] double nearest_angle(double theta) const;

 private:
  struct Part {
    pdg::ConvexPolygon vertices;  // exactly a part of the region, user's units
    Rectangle bounds;
    pdg::ConvexPolygon reachable;  // rounded: clipped to the domain; may be empty
    double area = 0.0;             // of that
  };
  // Turns, in units of 2^-60: from `begin`, `length` on; rounded outwards.
  struct Turns {
    std::uint64_t begin = 0;
    std::uint64_t length = kUnit;
  };

  [[nodiscard]] bool contains(Vec2 p) const;
  [[nodiscard]] Rectangle around(const CellSpace& space, const CellBox& box) const;
  [[nodiscard]] std::optional<double> angle_between(double first, double last) const;
  void append_point(std::vector<Configuration>& out, Vec2 p, double theta) const;

  const ScaledProblem& problem_;
  std::optional<GoalSet::Angles> angles_;
  Turns turns_;
  Rectangle reach_;  // the domain, user's units, rounded
  std::vector<Part> parts_;
  double area_ = 0.0;  // of all reachable parts
};

}  // namespace planner
