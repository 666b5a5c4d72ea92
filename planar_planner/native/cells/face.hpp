// Links between adjacent solid cells (docs/method.md, "Links"). A face is a cell
// with one half-extent zero; the same classification decides it, recursively.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "subdivision.hpp"

namespace planner {

// A free configuration on a common face, seen by the guards on both sides.
struct Connector {
  Vec2 t;                   // planner units
  std::uint64_t turns = 0;  // dyadic, in [0, 2^60]; 2^60 and 0 are the same angle
};

enum class LinkState : std::uint8_t {
  kOpen,      // a connector is known
  kBlocked,   // the whole face is FULL
  kDoubtful,  // still mixed at the limit: proves nothing either way
};

struct Link {
  LinkState state = LinkState::kDoubtful;
  Connector connector;
};

class FaceTest {
 public:
  FaceTest(const Subdivision& subdivision, Labeller& labeller, Statistics& statistics)
      : subdivision_(subdivision),
        labeller_(labeller),
        statistics_(statistics),
        posed_(labeller.robot()) {}

  // Both cells are solid leaves that share a face. Open links are remembered.
  Link test(CellId a, CellId b);
  // A cell is about to be split: its links go.
  void forget(CellId cell);
  // The proofs that faces are FULL, one claim for each part of a face; all of them stay true.
  [[nodiscard]] const std::vector<FullClaim>& blocked() const { return blocked_; }

 private:
  Link test_face(CellId a, CellId b);
  Link label_face(const Extent& face, const ConstraintView& parent, int depth, int& budget);
  std::optional<Connector> quick_connector(CellId a, CellId b, const Extent& face,
                                           const ConstraintView& list);

  const Subdivision& subdivision_;
  Labeller& labeller_;
  Statistics& statistics_;
  PosedRobot posed_;
  Scratch scratch_;
  std::unordered_map<std::uint64_t, Connector> open_;
  std::vector<FullClaim> blocked_;
};

}  // namespace planner
