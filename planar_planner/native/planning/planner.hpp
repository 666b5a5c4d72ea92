// The pipeline: a scene in; a path, a proof that there is none, or "undecided" out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "planar_planner/native/cells/cell_table.hpp"
#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/evidence/evidence.hpp"
#include "planar_planner/native/evidence/thinnest_wall.hpp"
#include "planar_planner/native/guesses/first_try.hpp"
#include "planar_planner/native/limits.hpp"
#include "planar_planner/native/paths/collision.hpp"
#include "planar_planner/native/paths/placement.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/search/query.hpp"
#include "planar_planner/native/statistics.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

struct PathCheck {
  std::int64_t bad_segment = -1;  // the first that is not certified, or -1
  double least_clearance = 0.0;   // certified lower bound, user's units; 0 if not certified
};

// Keeps the subdivision between queries. Not thread-safe.
class Planner {
 public:
  explicit Planner(Problem given, const Ablation& ablation = {});
  Planner(const Planner&) = delete;  // its parts refer to each other
  Planner& operator=(const Planner&) = delete;

  [[nodiscard]] const ScaledProblem& problem() const { return problem_; }
  Placement placement(const Configuration& q);
  Answer solve(const Configuration& start, const Goal& goal, const Limits& limits,
               const Listener& listener);
  // The same, but a path whose evidence cannot be written is left undecided: its room is within the
  // rounding of the evidence's bounds.
  Answer solve_certified(const Configuration& start, const Goal& goal, const Limits& limits,
                         const Listener& listener);
  PathCheck check_path(std::vector<Configuration> path);
  // The evidence of the last answer; computed now, since not every caller asks.
  Evidence evidence();
  // Certified lower bound along the last answer's path, user's units; 0 without a path.
  double least_clearance();
  // The thinnest place of the last answer if that is a separation, of a disc's if a disc stood for
  // the robot; empty otherwise.
  Crossing thinnest_wall();
  // The leaves of the subdivision; none if no query has needed cells.
  [[nodiscard]] CellTable cells() const;
  // The disc that stood for the robot (ClaimKind::kDisc).
  [[nodiscard]] const Planner& disc_inside() const { return *disc_inside_; }

 private:
  bool ends_not_free(Query& query);
  bool cheap_move(Query& query, CollisionHint& hint);
  bool cheap_move_to(Query& query, CollisionHint& hint, const Configuration& goal,
                     const Terminator& stop);
  bool probe(Query& query, CollisionHint& hint, std::optional<FirstTry>& first_try);
  bool disc_answer(Query& query, const Goal& goal, const Listener& listener);
  Answer ask_disc(Planner& disc, Query& query, const Goal& goal, const Listener& listener);
  bool conclude_path(Query& query, std::vector<Configuration> path, DecidedBy by);
  void subdivide(Query& query, FirstTry* first_try);
  void prepare_subdivision(const Query& query);
  void complete_answer(Query& query);
  void remember(const Query& query, const Configuration& start, const Goal& goal);
  void settle_lifted_ends(Query& query, const Configuration& start, const Goal& goal) const;
  [[nodiscard]] std::vector<CellId> leaves_of(const Configuration& q) const;
  [[nodiscard]] std::vector<CellId> leaves_of_goal(const Goal& goal) const;
  void confirm_absence(Query& query, const Configuration& start, const Goal& goal) const;

  // The last query, for its evidence: the user's ends, and the path without legs into contact.
  struct Last {
    Verdict verdict = Verdict::kUndecided;
    std::optional<DecidedBy> decided_by;
    Configuration start;
    Goal goal;
    std::vector<Configuration> waypoints;
  };

  ScaledProblem problem_;
  Last last_;
  Statistics statistics_;  // of the current query
  double preprocessing_ = 0.0;
  std::unique_ptr<ObstacleTree> tree_;
  std::unique_ptr<Labeller> labeller_;
  std::unique_ptr<SegmentTest> segments_;
  std::unique_ptr<Subdivision> subdivision_;
  std::unique_ptr<FaceTest> faces_;
  std::unique_ptr<Planner> disc_round_, disc_inside_;
  bool disc_prepared_ = false;
};

}  // namespace planner
