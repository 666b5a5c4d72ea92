// Obstacles as a bounding-volume hierarchy that is built, decomposed into convex pieces and scaled
// only where a search comes near. Pieces 0 .. wall_count() - 1 are the workspace's walls.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pdg/native/geometry/convex_piece.hpp"
#include "problem.hpp"

namespace planner {

inline constexpr std::uint32_t kNoPiece = UINT32_MAX;
inline constexpr std::uint32_t kWall = UINT32_MAX;  // polygon_of_piece of a wall

struct TreeNode {
  Vec2 low, high;             // bounds of everything below, rounded outwards
  double largest_leaf = 0.0;  // bounds the radius of any convex piece below
  std::uint32_t begin = 0;    // range of items
  std::uint32_t end = 0;
  std::uint32_t left = 0;          // children left, left + 1; 0 while not expanded
  std::uint32_t piece = kNoPiece;  // of a leaf that is one convex piece
};

class ObstacleTree {
 public:
  // What `obstacles` stands for must outlive the tree.
  ObstacleTree(const Obstacles& obstacles, const pdg::Frame& frame,
               const std::vector<pdg::ConvexPiece>& walls, bool partition = true);

  [[nodiscard]] std::uint32_t root() const { return 0; }
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] std::uint32_t wall_count() const { return wall_count_; }
  [[nodiscard]] const TreeNode& node(std::uint32_t i) const { return nodes_[i]; }
  [[nodiscard]] const pdg::ConvexPiece& piece(std::uint32_t i) const { return pieces_[i]; }
  // Index into the obstacles, or kWall.
  [[nodiscard]] std::uint32_t polygon_of_piece(std::uint32_t i) const { return polygons_[i]; }
  [[nodiscard]] std::size_t piece_count() const { return pieces_.size(); }
  // The one polygon that this node is, not yet decomposed.
  [[nodiscard]] std::optional<std::uint32_t> whole_polygon(const std::uint32_t index) const {
    const TreeNode& node = nodes_[index];
    if (node.end - node.begin != 1 || items_[node.begin].is_piece) return std::nullopt;
    return items_[node.begin].id;
  }
  // The convex hull of that polygon, if it is worth asking before it is decomposed: it holds it, so
  // what is apart from the one is apart from the other. Valid until another hull is asked for.
  const pdg::ConvexPiece* hull(std::uint32_t node);
  // Polygons not yet decomposed.
  [[nodiscard]] std::size_t untouched_polygons() const { return untouched_; }

  // Gives the node two children or a piece; does nothing if it has them. Invalidates references.
  void expand(const std::uint32_t node) {
    if (nodes_[node].left == 0 && nodes_[node].piece == kNoPiece) expand_new(node);
  }
  // Everything below the root.
  void expand_all();

 private:
  struct Item {
    Vec2 low, high;
    std::uint32_t id = 0;  // polygon, or piece if is_piece
    bool is_piece = false;
  };

  std::uint32_t add_node(std::uint32_t begin, std::uint32_t end);
  void bound(TreeNode& node) const;
  void expand_new(std::uint32_t node);
  void decompose(std::uint32_t node);
  void halve(std::uint32_t node);

  Obstacles obstacles_;
  pdg::Frame frame_;
  std::vector<pdg::ConvexPiece> pieces_;
  std::vector<std::uint32_t> polygons_;
  std::vector<TreeNode> nodes_;
  std::vector<Item> items_;
  bool partition_ = true;
  std::vector<std::optional<pdg::ConvexPiece>> hulls_;  // by polygon, made when first asked for
  std::uint32_t wall_count_ = 0;
  std::size_t untouched_ = 0;
};

}  // namespace planner
