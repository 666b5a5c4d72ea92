// The pipeline: a scene in; a path, a proof that there is none, or "undecided" out.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "channel.hpp"
#include "face.hpp"
#include "limits.hpp"
#include "path.hpp"
#include "problem.hpp"
#include "segment.hpp"
#include "statistics.hpp"
#include "subdivision.hpp"

namespace planner {

enum class Verdict : std::uint8_t { kPath, kNoPath, kUndecided };

struct Answer {
  Verdict verdict = Verdict::kUndecided;
  std::string reason;
  PathReport path;  // kPath
  Statistics statistics;
  std::array<std::uint64_t, 4> cells_by_label{};      // indexed by Label
  std::vector<std::uint64_t> cells_by_level;          // by the sum of the three axes' levels
};

enum class PlacementState : std::uint8_t { kFree, kContact, kColliding, kOutside };

struct Placement {
  PlacementState state = PlacementState::kFree;
  bool wall = false;                  // the workspace, not an obstacle
  bool reference = false;             // outside the reference bounds
  std::int64_t obstacle = -1;         // polygon
  std::uint32_t robot_polygon = 0;
  double depth = 0.0;                 // max over pairs of PD^t, user's units
  double clearance = 0.0;             // certified lower bound, user's units
};

struct PathCheck {
  std::int64_t bad_segment = -1;  // the first that is not certified, or -1
  double least_clearance = 0.0;   // certified lower bound, user's units; 0 if not certified
};

// Keeps the subdivision between queries. Not thread-safe.
class Planner {
 public:
  explicit Planner(Scene scene);
  Planner(const Planner&) = delete;  // its parts refer to each other
  Planner& operator=(const Planner&) = delete;

  [[nodiscard]] const Problem& problem() const { return problem_; }
  Placement placement(const Configuration& q);
  Answer solve(const Configuration& start, const Configuration& goal, const Limits& limits,
               const Listener& listener);
  PathCheck check_path(std::vector<Configuration> path);

 private:
  struct Query;

  bool trivial_answer(Query& query);
  bool cheap_move(Query& query);
  void subdivide(Query& query);
  bool refine(Query& query, const std::vector<CellId>& channel);
  void split(Query& query, CellId cell);
  bool link_channel(Query& query, const std::vector<CellId>& channel,
                    std::vector<Connector>& connectors);
  void resolve_doubt(Query& query, CellId a, CellId b);
  bool finish_path(Query& query, const std::vector<CellId>& channel,
                   const std::vector<Connector>& connectors);
  bool out_of_limits(Query& query);
  void prepare_subdivision(const Query& query);
  void take_census(Answer& answer) const;
  [[nodiscard]] std::array<std::uint64_t, 3> dyadic(const Configuration& q) const;

  Problem problem_;
  Statistics statistics_;  // of the current query
  double preprocessing_ = 0.0;
  std::unique_ptr<ObstacleTree> tree_;
  std::unique_ptr<Labeller> labeller_;
  std::unique_ptr<SegmentTest> segments_;
  std::unique_ptr<Subdivision> subdivision_;
  std::unique_ptr<FaceTest> faces_;
};

}  // namespace planner
