#include "read_scene.hpp"

#include <cstddef>
#include <istream>
#include <optional>
#include <stdexcept>

namespace bench {

namespace {

using planner::PolygonSet;
using planner::Rectangle;

template <class T>
T read(std::istream& in) {
  T value{};
  if (!(in >> value)) throw std::runtime_error("the scene ends early or is not all numbers");
  return value;
}

pdg::Vec2 read_point(std::istream& in) {
  const auto x = read<double>(in);
  return {x, read<double>(in)};
}

std::optional<Rectangle> read_box(std::istream& in) {
  if (read<int>(in) == 0) return std::nullopt;
  const pdg::Vec2 low = read_point(in);
  return Rectangle{low, read_point(in)};
}

PolygonSet read_polygons(std::istream& in) {
  PolygonSet set;
  set.points.resize(read<std::size_t>(in));
  for (pdg::Vec2& p : set.points) p = read_point(in);
  set.ring_starts.resize(read<std::size_t>(in));
  for (std::uint32_t& start : set.ring_starts) start = read<std::uint32_t>(in);
  set.polygon_starts.resize(read<std::size_t>(in));
  for (std::uint32_t& start : set.polygon_starts) start = read<std::uint32_t>(in);
  return set;
}

planner::Configuration read_configuration(std::istream& in) {
  const pdg::Vec2 t = read_point(in);
  return {t.x, t.y, read<double>(in)};
}

}  // namespace

Task read_task(std::istream& in) {
  Task task;
  task.scene.rotation = read<int>(in) != 0;
  task.scene.box = read_box(in);
  task.scene.reference_bounds = read_box(in);
  if (read<int>(in) != 0) task.scene.workspace = read_polygons(in).polygon(0);
  task.scene.robot = read_polygons(in);
  task.scene.obstacles = read_polygons(in);
  task.start = read_configuration(in);
  task.goal = read_configuration(in);
  return task;
}

}  // namespace bench
