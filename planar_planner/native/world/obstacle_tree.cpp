#include "obstacle_tree.hpp"

#include <algorithm>
#include <cmath>

#include "pdg/native/geometry/convex_hull.hpp"
#include "pdg/native/tolerances.hpp"
#include "pieces.hpp"
#include "tuning.hpp"

namespace planner {

namespace {

// Bounds that hold for the exact coordinates: to_frame errs by u per unit of magnitude.
void round_outwards(Vec2& low, Vec2& high) {
  const double slack =
      pdg::kVertexUnits * pdg::kUnitRoundoff *
      std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  low = {low.x - slack, low.y - slack};
  high = {high.x + slack, high.y + slack};
}

double half_diagonal(const Vec2 low, const Vec2 high) {
  return 0.5 * pdg::norm(high - low) * pdg::kRadiusPadding;
}

}  // namespace

ObstacleTree::ObstacleTree(const Obstacles& obstacles, const pdg::Frame& frame,
                           const std::vector<pdg::ConvexPiece>& walls, const bool partition)
    : obstacles_(obstacles),
      frame_(frame),
      pieces_(walls),
      polygons_(walls.size(), kWall),
      partition_(partition),
      wall_count_(static_cast<std::uint32_t>(walls.size())),
      untouched_(obstacles.size()) {
  items_.resize(obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Rectangle box = obstacles.bounds(i);
    Item& item = items_[i];
    item.low = pdg::to_frame(frame, box.low);
    item.high = pdg::to_frame(frame, box.high);
    round_outwards(item.low, item.high);
    item.id = static_cast<std::uint32_t>(i);
  }
  if (!items_.empty()) add_node(0, static_cast<std::uint32_t>(items_.size()));
}

std::uint32_t ObstacleTree::add_node(const std::uint32_t begin, const std::uint32_t end) {
  TreeNode node;
  node.begin = begin;
  node.end = end;
  bound(node);
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void ObstacleTree::bound(TreeNode& node) const {
  node.low = items_[node.begin].low;
  node.high = items_[node.begin].high;
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const Item& item = items_[i];
    node.low = {std::min(node.low.x, item.low.x), std::min(node.low.y, item.low.y)};
    node.high = {std::max(node.high.x, item.high.x), std::max(node.high.y, item.high.y)};
    node.largest_leaf = std::max(node.largest_leaf, half_diagonal(item.low, item.high));
  }
}

const pdg::ConvexPiece* ObstacleTree::hull(const std::uint32_t index) {
  const std::optional<std::uint32_t> polygon = whole_polygon(index);
  if (!polygon) return nullptr;
  if (hulls_.empty()) hulls_.resize(obstacles_.size());
  std::optional<pdg::ConvexPiece>& hull = hulls_[*polygon];
  if (!hull) {
    const std::span<const Vec2> ring = obstacles_.outer_ring(*polygon);
    if (ring.size() < kHullVertices || ring.size() > kMaxPieceVertices) return nullptr;
    hull = pdg::make_piece(pdg::convex_hull(std::vector<Vec2>(ring.begin(), ring.end())), frame_);
  }
  return &*hull;
}

void ObstacleTree::expand_new(const std::uint32_t index) {
  const TreeNode& node = nodes_[index];
  if (node.end - node.begin == 1 && !items_[node.begin].is_piece) decompose(index);
  if (nodes_[index].end - nodes_[index].begin > 1)
    halve(index);
  else
    nodes_[index].piece = items_[nodes_[index].begin].id;
}

void ObstacleTree::expand_all() {
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) expand(node);
}

void ObstacleTree::decompose(const std::uint32_t index) {
  const std::uint32_t polygon = items_[nodes_[index].begin].id;
  const auto begin = static_cast<std::uint32_t>(items_.size());
  for (const pdg::ConvexPolygon& part : planner_pieces(obstacles_.polygon(polygon), partition_)) {
    const pdg::ConvexPiece piece = pdg::make_piece(part, frame_);
    Item item;
    item.low = item.high = piece.edges[0].vertex;
    for (const pdg::Edge& edge : piece.edges) {
      item.low = {std::min(item.low.x, edge.vertex.x), std::min(item.low.y, edge.vertex.y)};
      item.high = {std::max(item.high.x, edge.vertex.x), std::max(item.high.y, edge.vertex.y)};
    }
    round_outwards(item.low, item.high);
    item.id = static_cast<std::uint32_t>(pieces_.size());
    item.is_piece = true;
    items_.push_back(item);
    pieces_.push_back(piece);
    polygons_.push_back(polygon);
  }
  TreeNode& node = nodes_[index];
  node.begin = begin;
  node.end = static_cast<std::uint32_t>(items_.size());
  --untouched_;
}

// Splits at the median centre along the longer side; ties broken by id, so that the order is
// independent of the library's nth_element.
void ObstacleTree::halve(const std::uint32_t index) {
  const TreeNode node = nodes_[index];
  const bool along_x = node.high.x - node.low.x >= node.high.y - node.low.y;
  const auto key = [along_x](const Item& item) {
    return along_x ? item.low.x + item.high.x : item.low.y + item.high.y;
  };
  const auto begin = items_.begin() + node.begin;
  const auto end = items_.begin() + node.end;
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](const Item& a, const Item& b) {
    return key(a) < key(b) || (key(a) == key(b) && a.id < b.id);
  });
  const auto split = static_cast<std::uint32_t>(middle - items_.begin());
  const std::uint32_t left = add_node(node.begin, split);
  add_node(split, node.end);
  nodes_[index].left = left;
}

}  // namespace planner
