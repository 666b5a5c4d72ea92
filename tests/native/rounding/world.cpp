#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pdg/native/geometry/predicates.hpp"
#include "planar_planner/native/world/pieces.hpp"

namespace rounding {

namespace {

// Andrew's monotone chain with the exact predicate.
ConvexPolygon hull_of(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), pdg::lexicographically_less);
  ConvexPolygon hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Vec2 p : points) {
      if (hull.size() > base && hull.back() == p) continue;
      while (hull.size() >= base + 2 && pdg::orient2d(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Turned about the origin, scaled, moved.
struct Placing {
  double angle = 0.0;
  pdg::Rotation turn;
  double scale = 1.0;
  Vec2 origin;

  [[nodiscard]] Vec2 shape(const Vec2 p) const { return scale * pdg::rotate(turn, p); }
  [[nodiscard]] Vec2 place(const Vec2 p) const { return origin + scale * p; }
};

pdg::Polygon rectangle(const Placing& placing, const Vec2 low, const Vec2 high) {
  return {{{placing.place(low), placing.place({high.x, low.y}), placing.place(high),
            placing.place({low.x, high.y})}}};
}

pdg::Polygon robot_rectangle(const Placing& placing, const double length, const double width,
                             const Vec2 centre) {
  const double x = 0.5 * length;
  const double y = 0.5 * width;
  pdg::Ring ring{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  for (Vec2& p : ring) p = placing.shape(p + centre);
  return {{ring}};
}

double slight(Random& random, const bool adversarial) {
  if (random.one_in(5)) return 0.0;
  return random.sign() * random.magnitude(1e-16, adversarial && random.one_in(2) ? 1e-14 : 1e-3);
}

// A wall with a slot as wide as the robot, or nearly.
void slot(Random& random, const Placing& placing, const bool adversarial, Stage& stage) {
  const double width = random.between(0.1, 0.6);
  const double half = 0.5 * width;
  planner::Problem& scene = stage.scene;
  scene.robot.append(robot_rectangle(placing, random.between(0.6, 1.5),
                                     width * (1.0 + slight(random, adversarial)), {0.0, 0.0}));
  scene.obstacles.append(rectangle(placing, {-0.5, half}, {0.5, 2.0}));
  scene.obstacles.append(rectangle(placing, {-0.5, -2.0}, {0.5, -half}));
  scene.box = planner::Rectangle{placing.place({-2.0, -2.0}), placing.place({2.0, 2.0})};
  stage.critical = {placing.origin.x, placing.origin.y, -placing.angle};
}

// Round a corner with a robot of nearly the greatest length that fits.
void corner(Random& random, const Placing& placing, const bool adversarial, Stage& stage) {
  const double width = random.between(0.05, 0.3);
  const double length = 2.0 * (std::numbers::sqrt2 - width) * (1.0 + slight(random, adversarial));
  planner::Problem& scene = stage.scene;
  scene.robot.append(robot_rectangle(placing, length, width, {0.0, 0.0}));
  scene.obstacles.append(rectangle(placing, {1.0, 1.0}, {4.0, 4.0}));
  scene.box = planner::Rectangle{placing.place({0.0, 0.0}), placing.place({4.0, 4.0})};
  const double middle = 1.0 - 0.5 * width / std::numbers::sqrt2;
  const Vec2 t = placing.place({middle, middle});
  stage.critical = {t.x, t.y, -std::numbers::pi / 4 - placing.angle};
}

void shapes(Random& random, const Placing& placing, const bool adversarial,
            planner::Problem& scene) {
  const int robots = random.one_in(4) ? 2 : 1;
  const double off = random.one_in(4) ? 2.0 : 0.3;
  for (int i = 0; i < robots; ++i) {
    const Vec2 centre = placing.scale * Vec2{off * random.between(-1.0, 1.0), off * random.unit()};
    scene.robot.append({{polygon(random, any_shape(random, adversarial),
                                 placing.scale * random.magnitude(0.05, 1.0), centre)}});
  }
  for (int i = random.pick(1, 3); i > 0; --i) {
    const Vec2 centre = placing.place({random.between(-2.0, 2.0), random.between(-2.0, 2.0)});
    scene.obstacles.append({{polygon(random, any_shape(random, adversarial),
                                     placing.scale * random.magnitude(0.1, 1.5), centre)}});
  }
  scene.box = planner::Rectangle{placing.place({-2.0, -2.0}), placing.place({2.0, 2.0})};
}

}  // namespace

World::World(planner::Problem scene, const double theta)
    : problem(planner::make_scaled_problem(std::move(scene))),
      tree(all_obstacles(problem), problem.frame, problem.walls),
      labeller(problem.robot, tree, statistics),
      posed(problem.robot),
      space{problem.domain, problem.rotation, theta} {
  const pdg::Frame own = exact::robot_frame(problem.frame);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < problem.given.robot.size(); ++i) {
    const pdg::Polygon polygon = problem.given.robot.polygon(i);
    points.insert(points.end(), polygon.rings[0].begin(), polygon.rings[0].end());
    for (const ConvexPolygon& piece : planner::planner_pieces(polygon))
      robot.push_back(exact::framed(own, piece));
  }
  robot.push_back(exact::framed(own, hull_of(points)));
  reach = exact::reach(robot.back());
  const planner::Obstacles all = all_obstacles(problem);
  for (std::size_t i = 0; i < all.size(); ++i) {
    obstacles.emplace_back();
    for (const ConvexPolygon& piece : planner::planner_pieces(all.polygon(i)))
      obstacles.back().push_back(exact::framed(problem.frame, piece));
  }
  if (!problem.given.box) return;
  const exact::Vector low = exact::framed(problem.frame, problem.given.box->low);
  const exact::Vector high = exact::framed(problem.frame, problem.given.box->high);
  walls = {{{exact::Ball(1.0), exact::Ball()}, low.x},
           {{exact::Ball(-1.0), exact::Ball()}, -high.x},
           {{exact::Ball(), exact::Ball(1.0)}, low.y},
           {{exact::Ball(), exact::Ball(-1.0)}, -high.y}};
}

// A polygon is decomposed at once, so its pieces follow one another.
const exact::Piece& World::obstacle(const std::uint32_t tree_piece) const {
  const std::uint32_t polygon = tree.polygon_of_piece(tree_piece);
  std::uint32_t first = tree_piece;
  while (first > 0 && tree.polygon_of_piece(first - 1) == polygon) --first;
  return obstacles[polygon][tree_piece - first];
}

Stage any_stage(Random& random, const bool adversarial) {
  Placing placing;
  if (random.one_in(3)) {
    placing.angle = random.one_in(2) ? std::numbers::pi / 4 : random.between(0.0, 6.0);
    placing.turn = {std::cos(placing.angle), std::sin(placing.angle)};
  }
  if (adversarial && random.one_in(2)) placing.scale = random.magnitude(1e-9, 1e9);
  const double far = adversarial && random.one_in(3) ? random.magnitude(1.0, 1e9) : 0.0;
  placing.origin = placing.scale * far * Vec2{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
  Stage stage;
  const int kind = random.pick(0, adversarial ? 4 : 6) / 2;
  if (kind == 1)
    slot(random, placing, adversarial, stage);
  else if (kind == 0)
    corner(random, placing, adversarial, stage);
  else
    shapes(random, placing, adversarial, stage.scene);
  stage.scene.rotation = kind == 0 || !random.one_in(8);
  return stage;
}

}  // namespace rounding
