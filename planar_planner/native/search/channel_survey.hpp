// What is known of a channel that is still MIXED: which of its cells hold a free configuration, and
// which of these are joined by certified segments. Splitting such cells cannot cut the channel any
// more: what is stuck is elsewhere, and only there smaller cells are worth their work. All of it is
// kept from one channel to the next. It proves nothing but the segments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "planar_planner/native/cells/face.hpp"
#include "planar_planner/native/guesses/ridge_path.hpp"

namespace planner {

struct Survey {
  std::vector<CellId> stuck;  // MIXED cells without a free configuration, or at a gap
  // Solid neighbours whose free configurations could not be joined.
  std::vector<std::pair<CellId, CellId>> apart;
  std::vector<Configuration> path;  // from start to goal, certified; empty if there is any of these
};

class ChannelSurvey {
 public:
  ChannelSurvey(const ScaledProblem& problem, const ObstacleTree& tree,
                const Subdivision& subdivision, SegmentTest& segments, Statistics& statistics)
      : problem_(problem),
        subdivision_(subdivision),
        ridge_(problem, tree, subdivision, segments, statistics) {}

  // All empty if the channel is too coarse yet, or the terminator struck.
  Survey look(const std::vector<CellId>& channel, const Configuration& start,
              const Configuration& goal, const Terminator& stop);

  // Joins solid neighbours by a configuration that both see; false if that is not certified.
  bool join_by(CellId from, CellId to, const Connector& connector, const Terminator& stop);

  [[nodiscard]] std::size_t bytes() const;

  // A leaf was halved: nothing that was known of it is known of the half that keeps its name.
  void forget(CellId cell);

 private:
  struct Place {
    enum class State : std::uint8_t { kUnknown, kNone, kHeld, kCoarse };
    State state = State::kUnknown;
    std::uint32_t version = 0;  // halvings of the leaf of this name
    ScaledConfiguration q;
  };
  struct Join {
    std::uint32_t from = 0, to = 0;  // versions of the two places
    bool certified = false;
    std::vector<ScaledConfiguration> way;  // after the first place, theta near that one's
  };

  const Place& place_of(CellId cell);
  const Join& join(CellId from, CellId to);
  void stick(Survey& out, CellId a, CellId b) const;

  const ScaledProblem& problem_;
  const Subdivision& subdivision_;
  RidgePath ridge_;
  std::vector<Place> places_;  // by cell
  std::unordered_map<std::uint64_t, Join> joins_;
};

}  // namespace planner
