// The search: refine only what a channel needs, until the channel is a path or there is none.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "channel.hpp"
#include "channel_survey.hpp"
#include "goal_cells.hpp"
#include "planar_planner/native/cells/census.hpp"
#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/cells/subdivision.hpp"
#include "planar_planner/native/guesses/first_try.hpp"
#include "planar_planner/native/guesses/ridge_attempts.hpp"
#include "planar_planner/native/paths/segment.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"
#include "query.hpp"

namespace planner {

// Borrows the planner's parts for one query; the subdivision and the known links stay behind.
class Search {
 public:
  Search(const ScaledProblem& problem, ObstacleTree& tree, Subdivision& subdivision,
         FaceTest& faces, SegmentTest& segments, Statistics& statistics, Query& query,
         FirstTry* first_try = nullptr);

  // Concludes the query.
  void run();

 private:
  void begin_search();
  [[nodiscard]] bool goal_connected() const;
  bool pick_goal(CellId cell);
  void drop_goal(GoalCells& goals, CellId cell);
  bool take_back_goals();
  [[nodiscard]] bool solid(const std::vector<CellId>& channel) const;
  [[nodiscard]] std::vector<CellId> all_cells() const;
  bool split_mixed(const std::vector<CellId>& channel);
  bool time_for_all_links();
  bool link(const std::vector<CellId>& channel);
  void resolve_doubts(const std::vector<std::pair<CellId, CellId>>& links);
  CellId resolve_doubt(CellId a, CellId b);
  bool finish(const std::vector<CellId>& channel);
  [[nodiscard]] std::uint64_t cells_work() const;
  bool try_trees();
  bool try_ridge(const std::vector<CellId>& channel);
  bool split_stuck(const std::vector<CellId>& channel);
  void join_solid(CellId a, CellId b);
  void conclude_path(std::vector<Configuration> path, DecidedBy by);
  void split(CellId cell);
  CellId halve(CellId cell);
  Link test_face(CellId a, CellId b);
  void exhaust(CellId cell);
  bool stop();
  [[nodiscard]] Progress progress() const;

  const ScaledProblem& problem_;
  ObstacleTree& tree_;
  Subdivision& subdivision_;
  FaceTest& faces_;
  SegmentTest& segments_;
  Statistics& statistics_;
  Query& query_;
  std::array<std::uint64_t, 3> start_point_, goal_point_;  // no goal point with a region
  std::optional<GoalCells> goals_;                         // of the region, if there is one
  ChannelSearch channels_;
  std::vector<Connector> connectors_;
  // Steps of the search: before the last channel was linked, after all links of one were tested,
  // and since then after single ones.
  struct {
    std::uint64_t before = 0, after_all = 0, after_single = 0;
    bool tested_all = true;
  } link_steps_;
  RidgeAttempts ridge_;
  ChannelSurvey survey_;
  std::uint64_t survey_work_ = 0;  // of Statistics::axis_work(), what surveys have cost
  FirstTry* first_try_;            // goes on beside the cells; null if there is none
  std::uint64_t work_before_ = 0;  // cells_work when it had its last turn
};

}  // namespace planner
