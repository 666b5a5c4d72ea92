// Straight motions: the angle follows the translation, so the box round a part is only a bound.
#include <queue>

#include "exact.hpp"

namespace exact {

namespace {

const Ball kHalf(0.5);
constexpr int kMostHalvings = 4000;
// The cosine's and the sine's remainders hold for any turn; beyond this they are of no use.
constexpr double kWidestExpansion = 1.5;
// Beyond all values of use, and still far from overflow.
constexpr double kUnlimited = 0x1p+1000;

// A part of a straight motion: t + s g1, turned further by s turn, |s| <= 1.
struct Part {
  Box box;  // uncoupled
  Ball turn;
};

Part part_of(const Way& way, const Stretch& u) {
  const Ball middle = (u.begin + u.end) * kHalf;
  const Ball half = (u.end - u.begin) * kHalf;
  Part part;
  part.turn = half * way.turn;
  part.box.t = way.start + middle * way.along;
  part.box.g1 = half * way.along;
  part.box.rotation = sine_cosine(way.theta + middle * way.turn);
  part.box.h = absolute(part.turn);
  part.box.half = sine_cosine(part.box.h);
  return part;
}

// To first order about the middle, less what the rest can be: |v| h^2/2 + |w| h^3/6 of
// v cos + w sin, and for an edge of the robot h |g| for the translation seen from a turned normal.
Ball expanded_least(const Piece& a, const Piece& b, const Axis& axis, const Part& part) {
  const bool obstacle = axis.owner == pdg::EdgeOwner::kObstacle;
  const Box& box = part.box;
  const Ball& h = box.h;
  const Vector n = obstacle ? b.normals[axis.edge] : rotated(box.rotation, a.normals[axis.edge]);
  const Piece& others = obstacle ? a : b;
  Ball lowest;
  for (std::size_t k = 0; k < others.vertices.size(); ++k) {
    const Vector p =
        obstacle ? rotated(box.rotation, others.vertices[k]) : others.vertices[k] - box.t;
    const Ball v = dot(n, p);
    const Ball w = obstacle ? dot(n, perpendicular(p)) : dot(perpendicular(n), p);
    const Ball slope = (obstacle ? dot(n, box.g1) : -dot(n, box.g1)) + w * part.turn;
    Ball rest = absolute(v) * h * h / Ball(2.0) + absolute(w) * h * h * h / Ball(6.0);
    if (!obstacle) rest = rest + h * length(box.g1);
    const Ball here = v - absolute(slope) - rest;
    lowest = k == 0 ? here : least(lowest, here);
  }
  return lowest + (obstacle ? dot(n, box.t - b.vertices[axis.edge])
                            : -dot(a.normals[axis.edge], a.vertices[axis.edge]));
}

Ball bound_over(const Piece& a, const Piece& b, const Axis& axis, const Part& part) {
  const Ball uncoupled = least_value(a, b, axis, part.box);
  if (!(Ball(kWidestExpansion) - part.box.h).certainly_positive()) return uncoupled;
  return greatest(uncoupled, expanded_least(a, b, axis, part));
}

struct Bounded {
  Stretch stretch;
  Ball bound;
};

bool operator<(const Bounded& a, const Bounded& b) {  // the lowest bound is on top of the queue
  return a.bound.middle > b.bound.middle;
}

}  // namespace

Ball least_value(const Piece& a, const Piece& b, const Axis& axis, const Way& way,
                 const Stretch& stretch, const double wanted, const double slack) {
  const auto bounded = [&](const Stretch& u) {
    return Bounded{u, bound_over(a, b, axis, part_of(way, u))};
  };
  std::priority_queue<Bounded> open;
  open.push(bounded(stretch));
  Ball seen(kUnlimited);  // least of the values at middles
  for (int halvings = 0; halvings < kMostHalvings; ++halvings) {
    const auto [u, bound] = open.top();
    if ((bound - Ball(wanted)).certainly_not_negative()) break;
    const Ball middle = (u.begin + u.end) * kHalf;
    seen = least(seen, bounded({middle, middle}).bound);
    const bool below = (seen - Ball(wanted)).certainly_negative();
    if (below && (bound + Ball(slack) - seen).certainly_not_negative()) break;
    open.pop();
    open.push(bounded({u.begin, middle}));
    open.push(bounded({middle, u.end}));
  }
  return open.top().bound;
}

bool apart(const Piece& a, const Piece& b, const Way& way, const Stretch& stretch) {
  for (const Axis& axis : axes_of(a, b))
    if (least_value(a, b, axis, way, stretch, 0.0, kUnlimited).certainly_not_negative())
      return true;
  return false;
}

}  // namespace exact
