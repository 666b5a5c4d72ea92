// The pipeline: a scene in; a path, a proof that there is none, or "undecided" out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "layer_decision.hpp"
#include "layer_join.hpp"
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
  // What rounded arithmetic decides also holds if every coordinate of robot, obstacles, bounds and
  // ends is off by so much; user's units.
  [[nodiscard]] double tolerated_error() const;
  Placement placement(const Configuration& q);
  Answer solve(const Configuration& start, const Goal& goal, const Limits& limits,
               const Listener& listener);
  // The same, with a path for which evidence can be written. Where its room is within the bound of
  // rounding, the evidence has to be checked exactly (Answer::to_be_checked); where even less is
  // left, an exact path may take its place, or the query is left undecided.
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
  // Whose cells the last query's are, and its separation: this planner, or the one about a point of
  // the body. A path is always of the robot's own frame.
  [[nodiscard]] const Planner& planned_by() const { return by_body_ ? *about_body_ : *this; }
  // That point, in the robot's frame; the origin for this planner itself.
  [[nodiscard]] Vec2 planned_point() const { return by_body_ ? point_ : Vec2{}; }

 private:
  static constexpr std::uint64_t kNoPause = UINT64_MAX;

  // about_body.cpp
  void prepare_about_body(const Ablation& ablation);
  std::optional<Answer> solve_about_body(const Configuration& start, const Configuration& goal,
                                         const Limits& limits, const Listener& listener);
  bool take_over(Query& query, const Configuration& start, const Configuration& goal);
  bool retrace(Query& query);

  // contact.cpp
  bool leave_contact(Query& query, const Configuration& start, const Goal& goal, bool at_start);
  void add_exact_legs(Query& query) const;
  LayerJoin join_layers(Query& query, const Goal& goal);
  std::optional<std::vector<Configuration>> through_leaves(const Query& query, CellId from,
                                                           const Configuration& start, CellId to,
                                                           const Configuration& goal);
  [[nodiscard]] CellId leaf_of(const Configuration& q) const;
  void begin_path(Evidence& evidence) const;
  bool exact_instead(Answer& answer, const Configuration& start, const Goal& goal);
  bool ends_settle_it(Query& query, const Configuration& start, const Goal& goal);
  bool guess(Query& query, CollisionHint& hint, const Goal& goal, const Listener& listener,
             std::optional<FirstTry>& first_try);
  bool small_subdivision(Query& query, const Configuration& start, const Goal& goal,
                         FirstTry* first_try);
  void settle_resolution(Query& query, const Configuration& start, const Goal& goal);
  bool cheap_move(Query& query, CollisionHint& hint);
  bool cheap_move_to(Query& query, CollisionHint& hint, const Configuration& goal,
                     const Terminator& stop);
  bool probe(Query& query, CollisionHint& hint, std::optional<FirstTry>& first_try);
  bool disc_answer(Query& query, const Goal& goal, const Listener& listener);
  Answer ask_disc(Planner& disc, Query& query, const Goal& goal, const Listener& listener);
  bool layer_answer(Query& query, const Configuration& start, const Goal& goal);
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
    double share = 1.0;  // of the rounding's bound, that its evidence keeps off
    std::vector<ExactRun> exact;
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
  std::vector<Layer> layers_;           // of the last query's exact legs
  std::optional<LayerDecision> layer_;  // of the last query, if that was decided exactly
  std::unique_ptr<Planner> disc_round_, disc_inside_;
  bool disc_prepared_ = false;
  std::uint64_t pause_ = kNoPause;  // cells at which the search stops for the exact decision
  double end_error_ = 0.0;  // the ends asked may be off the exact ones by so much; user's units
  // The same problem about a point of the body, if the origin of the robot's frame is far from it.
  std::unique_ptr<Planner> about_body_;
  Vec2 point_;            // of the robot's frame
  bool by_body_ = false;  // the last query was answered about it
};

}  // namespace planner
