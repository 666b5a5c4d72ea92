// A bounding-volume hierarchy of axis-aligned boxes, built once.
#pragma once

#include <cstdint>
#include <vector>

#include "vec.hpp"

namespace pdg {

// Closed box; empty when low > high.
struct Box {
  Vec2 low;
  Vec2 high;
};

Box bounding_box(const std::vector<Vec2>& points);
Box joined(const Box& a, const Box& b);

constexpr Vec2 centre(const Box& box) {
  return {0.5 * box.low.x + 0.5 * box.high.x, 0.5 * box.low.y + 0.5 * box.high.y};
}

constexpr bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// Nodes in depth-first order. A leaf holds one box; an inner node's first child follows it.
struct BoxTree {
  struct Node {
    Box box;
    std::uint32_t after = 0;  // the node to go on with when this box is missed
    std::int32_t item = -1;   // index of the box in a leaf, -1 in an inner node
  };
  std::vector<Node> nodes;
};

BoxTree build_box_tree(const std::vector<Box>& boxes);

// Indices of the boxes that meet `box`, in the order of the tree.
void find_meeting(const BoxTree& tree, const Box& box, std::vector<std::int32_t>& found);

}  // namespace pdg
