// Convex sets: support values and points against what the sets promise about them; and brackets of
// d_Q(A) against exact support functions.
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <utility>

#include "families.hpp"
#include "generate.hpp"
#include "pdg/native/convex_sets/convex_composites.hpp"
#include "pdg/native/convex_sets/grasp_wrench_set.hpp"
#include "pdg/native/penetration_distance/penetration_distance.hpp"

namespace rounding {

namespace {

using exact::Ball;
using Coordinates = std::vector<double>;
using Direction = std::vector<Ball>;

constexpr std::uint64_t kInputsPerBracket = 100;

// A set of the library, and its support function.
struct Twin {
  pdg::SetPointer set;
  std::function<Ball(const Direction&)> support;
};

Ball product(const Coordinates& a, const Direction& u) {
  Ball sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + Ball(a[i]) * u[i];
  return sum;
}

Direction exactly(const Coordinates& u) {
  return {u.begin(), u.end()};
}

// Sizes of the axes; zeros and signs of numbers.
struct Kind {
  bool adversarial = false;
  Coordinates scales;  // of each coordinate
};

double number(Random& random, const Kind& kind) {
  if (kind.adversarial && random.one_in(6)) return 0.0;
  const double size = kind.adversarial ? random.magnitude(1e-9, 1.0) : 1.0;
  return size * random.between(-1.0, 1.0);
}

Coordinates numbers(Random& random, const Kind& kind) {
  Coordinates result;
  for (const double scale : kind.scales) result.push_back(scale * number(random, kind));
  return result;
}

Coordinates extents(Random& random, const Kind& kind) {
  Coordinates result = numbers(random, kind);
  for (double& x : result) x = std::abs(x);
  return result;
}

pdg::Matrix matrix(Random& random, const Kind& kind, const std::size_t columns) {
  pdg::Matrix m{kind.scales.size(), columns, {}};
  for (const double scale : kind.scales)
    for (std::size_t j = 0; j < columns; ++j) m.entries.push_back(scale * number(random, kind));
  return m;
}

// M^T u.
Direction pulled_back(const pdg::Matrix& m, const Direction& u) {
  Direction w(m.columns);
  for (std::size_t i = 0; i < m.rows; ++i)
    for (std::size_t j = 0; j < m.columns; ++j) w[j] = w[j] + Ball(m.row(i)[j]) * u[i];
  return w;
}

Ball length_of(const Direction& w) {
  Ball square;
  for (const Ball& x : w) square = square + x * x;
  return square_root(square);
}

Twin simple_set(Random& random, const Kind& kind) {
  const Coordinates c = random.one_in(3) ? Coordinates(kind.scales.size()) : numbers(random, kind);
  const Coordinates r = extents(random, kind);
  switch (random.pick(0, 4)) {
    case 0:
      return {pdg::axis_ellipsoid(r, c), [=](const Direction& u) {
                Direction w;
                for (std::size_t i = 0; i < r.size(); ++i) w.push_back(Ball(r[i]) * u[i]);
                return product(c, u) + length_of(w);
              }};
    case 1: {
      const pdg::Matrix m = matrix(random, kind, static_cast<std::size_t>(random.pick(1, 6)));
      return {pdg::ellipsoid(m, c),
              [=](const Direction& u) { return product(c, u) + length_of(pulled_back(m, u)); }};
    }
    case 2:
      return {pdg::box(r, c), [=](const Direction& u) {
                Ball sum = product(c, u);
                for (std::size_t i = 0; i < r.size(); ++i) sum = sum + Ball(r[i]) * absolute(u[i]);
                return sum;
              }};
    case 3:
      return {pdg::cross_polytope(r, c), [=](const Direction& u) {
                Ball most;
                for (std::size_t i = 0; i < r.size(); ++i)
                  most = greatest(most, Ball(r[i]) * absolute(u[i]));
                return product(c, u) + most;
              }};
    default: {
      std::vector<Coordinates> points;
      pdg::Matrix rows{static_cast<std::size_t>(random.pick(1, 9)), kind.scales.size(), {}};
      for (std::size_t k = 0; k < rows.rows; ++k) {
        points.push_back(numbers(random, kind));
        rows.entries.insert(rows.entries.end(), points.back().begin(), points.back().end());
      }
      return {pdg::point_set(rows), [=](const Direction& u) {
                Ball most = product(points[0], u);
                for (const Coordinates& p : points) most = greatest(most, product(p, u));
                return most;
              }};
    }
  }
}

// Contacts' ellipsoids c + M x.
Twin wrench_set(Random& random, const Kind& kind) {
  pdg::ContactWrenches w;
  w.contacts = static_cast<std::size_t>(random.pick(1, 4));
  w.dimension = kind.scales.size();
  w.axes = static_cast<std::size_t>(random.pick(1, 3));
  for (std::size_t k = 0; k < w.contacts * (1 + w.axes); ++k) {
    const Coordinates column = numbers(random, kind);
    w.columns.insert(w.columns.end(), column.begin(), column.end());
  }
  const auto norm = random.one_in(2) ? pdg::ForceNorm::kSum : pdg::ForceNorm::kLargest;
  const bool idle = random.one_in(2);
  return {pdg::grasp_wrench_set(w, norm, idle), [=](const Direction& u) {
            const auto column = [&](const std::size_t contact, const std::size_t j) {
              const auto first =
                  w.columns.begin() +
                  static_cast<std::ptrdiff_t>((contact * (1 + w.axes) + j) * w.dimension);
              return product({first, first + static_cast<std::ptrdiff_t>(w.dimension)}, u);
            };
            Ball total;
            for (std::size_t k = 0; k < w.contacts; ++k) {
              Direction along;
              for (std::size_t j = 1; j <= w.axes; ++j) along.push_back(column(k, j));
              Ball h = column(k, 0) + length_of(along);
              if (idle) h = greatest(h, Ball());
              if (norm == pdg::ForceNorm::kLargest)
                total = total + h;
              else
                total = k == 0 ? h : greatest(total, h);
            }
            return total;
          }};
}

Twin any_set(Random& random, const Kind& kind, int depth);

Twin several(Random& random, const Kind& kind, const int depth, const bool sum) {
  std::vector<pdg::SetPointer> sets;
  std::vector<Twin> parts;
  for (int k = random.pick(1, 3); k > 0; --k) {
    parts.push_back(any_set(random, kind, depth - 1));
    sets.push_back(parts.back().set);
  }
  return {sum ? pdg::minkowski_sum(sets) : pdg::union_hull(sets), [=](const Direction& u) {
            Ball total = parts[0].support(u);
            for (std::size_t k = 1; k < parts.size(); ++k)
              total = sum ? total + parts[k].support(u) : greatest(total, parts[k].support(u));
            return total;
          }};
}

Twin image(Random& random, const Kind& kind, const int depth) {
  Kind inside = kind;
  inside.scales.assign(static_cast<std::size_t>(random.pick(1, 6)), 1.0);
  const Twin part = any_set(random, inside, depth - 1);
  const pdg::Matrix m = matrix(random, kind, inside.scales.size());
  const Coordinates c = numbers(random, kind);
  return {pdg::affine_image(m, c, part.set),
          [=](const Direction& u) { return product(c, u) + part.support(pulled_back(m, u)); }};
}

Twin copy(Random& random, const Kind& kind, const int depth) {
  const Twin part = any_set(random, kind, depth - 1);
  const double factor = random.one_in(3) ? -1.0 : number(random, kind);
  return {pdg::scaled(factor, part.set), [=](const Direction& u) {
            Direction w;
            for (const Ball& x : u) w.push_back(Ball(factor) * x);
            return part.support(w);
          }};
}

Twin any_set(Random& random, const Kind& kind, const int depth) {
  const int which = depth == 0 ? 0 : random.pick(0, 6);
  switch (which) {
    case 3:
    case 4:
      return several(random, kind, depth, which == 3);
    case 5:
      return image(random, kind, depth);
    case 6:
      return copy(random, kind, depth);
    case 2:
      return wrench_set(random, kind);
    default:
      return simple_set(random, kind);
  }
}

Kind any_kind(Random& random, const bool adversarial, const int most_dimensions) {
  Kind kind{adversarial, {}};
  for (int i = random.pick(1, most_dimensions); i > 0; --i)
    kind.scales.push_back(adversarial && random.one_in(2) ? random.magnitude(1e-6, 1e6) : 1.0);
  return kind;
}

// The sizes make coordinates of different scale weigh alike.
Coordinates direction(Random& random, const Kind& kind) {
  Coordinates u;
  for (const double scale : kind.scales) u.push_back(number(random, kind) / scale);
  return u;
}

// The point lies within the errors of the set iff no direction w has w.p > h(w) + |w|.error.
void support(Random& random, const bool adversarial, Tally& values, Tally& points) {
  const Kind kind = any_kind(random, adversarial, 8);
  const Twin twin = any_set(random, kind, 3);
  const Coordinates u = direction(random, kind);
  ++values.inputs;
  ++points.inputs;
  const auto allowed = [&](const Coordinates& w) {
    double sum = 0.0;
    for (std::size_t i = 0; i < w.size(); ++i) sum += std::abs(w[i]) * twin.set->error()[i];
    return sum;
  };
  Coordinates p(u.size());
  const double value = pdg::support(*twin.set, u, p);
  const Ball truth = twin.support(exactly(u));
  if (allowed(u) > 0.0) {
    values.near(value, truth, allowed(u));
    values.near(twin.set->value(u), truth, allowed(u));
  }
  for (int k = 0; k < 8; ++k) {
    Coordinates w(u.size());
    if (k < 2)
      w[static_cast<std::size_t>(random.pick(0, static_cast<int>(u.size()) - 1))] = random.sign();
    else
      w = k == 2 ? u : direction(random, kind);
    if (!(allowed(w) > 0.0)) continue;
    const Ball beyond = product(p, exactly(w)) - twin.support(exactly(w));
    points.not_above(beyond.value(), Ball(Ball().middle, beyond.radius), allowed(w));
  }
}

// A round set and one that may be anything, both about the origin.
void largest_scale(Random& random, const bool adversarial, Tally& tally) {
  Kind kind = any_kind(random, false, 4);
  if (kind.scales.size() == 1) kind.scales.push_back(1.0);
  const Coordinates none(kind.scales.size());
  kind.adversarial = adversarial;
  const Twin part = any_set(random, kind, 2);
  const Coordinates radii(kind.scales.size(), random.magnitude(0.05, 1.0));
  const pdg::SetPointer ball = pdg::axis_ellipsoid(radii, none);
  const pdg::SetPointer whole = pdg::minkowski_sum({part.set, pdg::scaled(-1.0, part.set), ball});
  const auto whole_support = [&](const Direction& u) {
    Direction back;
    for (const Ball& x : u) back.push_back(-x);
    return part.support(u) + part.support(back) + Ball(radii[0]) * length_of(u);
  };
  const Twin q = simple_set(random, {false, kind.scales});
  const pdg::SetPointer measure = pdg::union_hull({q.set, pdg::axis_ellipsoid(none, none)});
  const auto measure_support = [&](const Direction& u) { return greatest(q.support(u), Ball()); };
  const pdg::PenetrationDistance found = pdg::penetration_distance(
      *whole, *measure, {0.0, random.magnitude(1e-9, 1e-2), 200, 20000}, [] { return false; });
  ++tally.inputs;
  if (found.state == pdg::OriginState::kOutside || found.direction.empty()) {
    tally.claim(false);  // a ball about the origin is in it
    return;
  }
  tally.claim(found.lower <= found.upper);
  const auto ratio = [&](const Coordinates& u) {
    return whole_support(exactly(u)) / measure_support(exactly(u));
  };
  const Ball attained = ratio(found.direction);
  if (std::isfinite(attained.radius)) {
    tally.claim((Ball(found.upper) - attained).certainly_not_negative());
    tally.claim((attained - Ball(found.lower)).certainly_not_negative());
  }
  for (int k = 0; k < 8; ++k) {
    Coordinates u = found.direction;
    for (double& x : u) x += random.magnitude(1e-9, 1.0) * random.between(-1.0, 1.0);
    const Ball here = ratio(u);
    if (std::isfinite(here.radius))
      tally.claim((here - Ball(found.lower)).certainly_not_negative());
  }
}

}  // namespace

std::vector<Tally> sets(const Request& request) {
  Random random(request.seed);
  std::vector<Tally> out{{.family = "convex sets, value", .leans_on_margin = false},
                         {.family = "convex sets, point", .leans_on_margin = false},
                         {.family = "d_Q", .leans_on_margin = false}};
  while (out[0].inputs < request.inputs) support(random, request.adversarial, out[0], out[1]);
  while (out[2].inputs * kInputsPerBracket < request.inputs)
    largest_scale(random, request.adversarial, out[2]);
  return out;
}

}  // namespace rounding
