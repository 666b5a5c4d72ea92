#include "box_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace pdg {
namespace {

double centre(const Box& box, const bool along_x) {
  return along_x ? 0.5 * box.low.x + 0.5 * box.high.x : 0.5 * box.low.y + 0.5 * box.high.y;
}

// Splits at the median centre along the longer side, so the depth is logarithmic.
void build(BoxTree& tree, const std::vector<Box>& boxes, const std::span<std::int32_t> items) {
  Box box = boxes[static_cast<std::size_t>(items.front())];
  for (const std::int32_t i : items) box = joined(box, boxes[static_cast<std::size_t>(i)]);
  const std::size_t node = tree.nodes.size();
  tree.nodes.push_back({box, 0, items.size() == 1 ? items.front() : -1});
  if (items.size() > 1) {
    const bool along_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const auto key = [&](const std::int32_t i) {
      return centre(boxes[static_cast<std::size_t>(i)], along_x);
    };
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [&](const std::int32_t a, const std::int32_t b) {
                       return key(a) != key(b) ? key(a) < key(b) : a < b;
                     });
    build(tree, boxes, items.first(half));
    build(tree, boxes, items.subspan(half));
  }
  tree.nodes[node].after = static_cast<std::uint32_t>(tree.nodes.size());
}

}  // namespace

Box bounding_box(const std::vector<Vec2>& points) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (const Vec2 p : points) box = joined(box, {p, p});
  return box;
}

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

BoxTree build_box_tree(const std::vector<Box>& boxes) {
  BoxTree tree;
  if (boxes.empty()) return tree;
  tree.nodes.reserve(2 * boxes.size());
  std::vector<std::int32_t> items(boxes.size());
  std::iota(items.begin(), items.end(), 0);
  build(tree, boxes, items);
  return tree;
}

void find_meeting(const BoxTree& tree, const Box& box, std::vector<std::int32_t>& found) {
  std::size_t i = 0;
  while (i < tree.nodes.size()) {
    const BoxTree::Node& node = tree.nodes[i];
    if (!boxes_meet(node.box, box)) {
      i = node.after;
      continue;
    }
    if (node.item >= 0) found.push_back(node.item);
    ++i;
  }
}

}  // namespace pdg
