// Is one configuration free? What a sampling planner asks a million times a second.
#pragma once

#include <cstdint>
#include <vector>

#include "pdg/native/geometry/motion.hpp"
#include "planar_planner/native/world/problem.hpp"
#include "planar_planner/native/world/scaled_problem.hpp"

namespace planner {

// Holds the whole scene flat: every obstacle piece that the robot can meet is decomposed when this
// is built, none per check. Not thread-safe: one per thread.
class StateCheck {
 public:
  // Copies what it needs.
  explicit StateCheck(const ScaledProblem& problem);

  // True: free, in exact arithmetic, for the very doubles of scene and q (x, y in the user's unit,
  // theta in radians), touching allowed. False: overlapping, out of bounds, not finite, or nearer
  // than the rounding error, in which case touching cannot be told from overlap: kContact and
  // kColliding of placement.hpp. Does not allocate.
  bool is_free(const Configuration& q);

  // Calls of is_free.
  [[nodiscard]] std::uint64_t checks() const { return checks_; }
  // Holds the reference point of every free configuration; user's unit.
  [[nodiscard]] Rectangle bounds() const { return bounds_; }
  // Largest distance of a robot vertex from the reference point, user's unit.
  [[nodiscard]] double robot_radius() const { return robot_radius_; }

 private:
  struct Piece {
    std::uint32_t first = 0;  // in the arrays of vertices, normals and offsets
    std::uint32_t count = 0;
    Vec2 centre, inner_centre;  // of circles round the piece and inside it
    double radius = 0.0;
    double inner_radius = 0.0;
    double error = 0.0;  // rounding bound of whatever is compared for this piece
  };
  // In depth-first order: the left child follows its parent.
  struct Node {
    Vec2 low, high;            // grown by the rounding bound of what they are compared with
    std::uint32_t escape = 0;  // the next node that is not below this one
    std::uint32_t piece = 0;   // of a leaf; kNoPiece otherwise
  };
  struct Shapes {
    std::vector<Piece> pieces;
    std::vector<Vec2> vertices;
    std::vector<Vec2> normals;    // of the edge that begins at the vertex
    std::vector<double> offsets;  // of that edge
    void add(const pdg::ConvexPiece& piece, double error);
  };

  void flatten(ObstacleTree& tree, std::uint32_t node, const pdg::Motion& domain);
  bool pose(const Configuration& q);
  [[nodiscard]] bool meets(const Node& node) const;
  bool overlaps(std::uint32_t obstacle);
  void turn_piece(std::size_t i);
  [[nodiscard]] bool separated(const Piece& a, const Piece& b) const;

  pdg::Frame frame_;
  double scale_ = 1.0;  // 2^frame exponent
  Vec2 scaled_origin_;
  Domain domain_;
  std::optional<Rectangle> reference_bounds_;
  std::optional<Rectangle> walls_;  // shrunk by the rounding bound
  Rectangle bounds_;
  double robot_radius_ = 0.0;
  double robot_reach_ = 0.0;  // planner units

  std::vector<Vec2> hull_;  // of the robot, in its own frame
  Shapes robot_, obstacles_;
  std::vector<Node> nodes_;

  // What belongs to the configuration that is being checked.
  Vec2 t_;
  pdg::Rotation rotation_;
  Vec2 low_, high_;  // bounds of the robot, placed
  Shapes turned_;    // the robot's pieces, turned but not moved
  std::vector<std::uint64_t> turned_at_;

  std::uint64_t checks_ = 0;
  std::uint32_t last_hit_ = kNoPiece;  // leaf node that the robot overlapped last
};

}  // namespace planner
