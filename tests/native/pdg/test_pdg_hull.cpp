// The simplicial hull against the definition of a convex hull, on random and on symmetric points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "pdg/native/penetration_distance/simplex_planes.hpp"
#include "pdg/native/penetration_distance/simplicial_hull.hpp"

namespace {

using Points = std::vector<std::vector<double>>;

double determinant(std::vector<std::vector<double>> m) {
  double product = 1.0;
  for (std::size_t c = 0; c < m.size(); ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < m.size(); ++r) {
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    }
    if (m[pivot][c] == 0.0) return 0.0;
    if (pivot != c) product = -product;
    std::swap(m[pivot], m[c]);
    product *= m[c][c];
    for (std::size_t r = c + 1; r < m.size(); ++r) {
      const double factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k < m.size(); ++k) m[r][k] -= factor * m[c][k];
    }
  }
  return product;
}

// Orders the points so that the first n + 1 are affinely independent.
Points with_simplex_first(Points points) {
  const std::size_t n = points.front().size();
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t p = k; p < points.size(); ++p) {
      std::swap(points[k], points[p]);
      std::vector<std::vector<double>> gram(k, std::vector<double>(k));
      for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < k; ++j) {
          for (std::size_t x = 0; x < n; ++x) {
            gram[i][j] += (points[i + 1][x] - points[0][x]) * (points[j + 1][x] - points[0][x]);
          }
        }
      }
      if (determinant(gram) > 1e-6) break;
      std::swap(points[k], points[p]);
    }
  }
  return points;
}

template <std::size_t N>
pdg::SimplicialHull<N> hull_of(const Points& points) {
  const std::size_t n = points.front().size();
  std::vector<double> simplex;
  for (std::size_t k = 0; k <= n; ++k) {
    simplex.insert(simplex.end(), points[k].begin(), points[k].end());
  }
  const auto planes = pdg::simplex_planes(n, simplex);
  EXPECT_TRUE(planes.has_value());
  pdg::SimplicialHull<N> hull(n, simplex, planes->planes);
  for (std::size_t p = n + 1; p < points.size(); ++p) {
    std::int32_t best = -1;
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(hull.id_bound()); ++f) {
      if (!hull.alive(f)) continue;
      if (best < 0 || hull.height(f, points[p]) > hull.height(best, points[p])) best = f;
    }
    hull.add(points[p], best);
  }
  return hull;
}

// The ridges pair up, whatever rounding did.
template <std::size_t N>
void expect_closed(const pdg::SimplicialHull<N>& hull) {
  const std::size_t n = hull.dimension();
  std::size_t live = 0;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(hull.id_bound()); ++f) {
    if (!hull.alive(f)) continue;
    ++live;
    for (std::size_t k = 0; k < n; ++k) {
      const std::int32_t other = hull.neighbour(f, k);
      ASSERT_TRUE(hull.alive(other));
      const std::set<std::int32_t> theirs(hull.vertices(other).begin(), hull.vertices(other).end());
      std::size_t back = 0;
      for (std::size_t j = 0; j < n; ++j) {
        if (j != k) {
          ASSERT_TRUE(theirs.contains(hull.vertices(f)[j]));
        }
        back += hull.neighbour(other, j) == f ? 1 : 0;
      }
      ASSERT_GE(back, 1U);
    }
  }
  EXPECT_EQ(live, hull.facet_count());
}

// The error of a plane grows by kSeenHeight, or rounding, a point.
constexpr double kHeightError = 1000 * pdg::kSeenHeight;

// All points below all planes, and each facet's vertices on its plane.
template <std::size_t N>
void expect_convex(const pdg::SimplicialHull<N>& hull, const Points& points) {
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(hull.id_bound()); ++f) {
    if (!hull.alive(f)) continue;
    for (const auto& p : points) ASSERT_LE(hull.height(f, p), kHeightError);
    for (const std::int32_t v : hull.vertices(f)) {
      ASSERT_NEAR(hull.height(f, hull.point(v)), 0.0, kHeightError);
    }
  }
}

// Facets as ordered tuples of vertices, with signs that orient the closed surface: those of facets
// side by side induce opposite orientations on their ridge.
template <std::size_t N>
std::vector<int> orientations(const pdg::SimplicialHull<N>& hull) {
  const std::size_t n = hull.dimension();
  std::vector<int> signs(hull.id_bound());
  std::vector<std::int32_t> queue;
  for (std::int32_t f = 0; queue.empty(); ++f) {
    if (hull.alive(f)) queue.push_back(f);
  }
  signs[static_cast<std::size_t>(queue.front())] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::int32_t f = queue[next];
    for (std::size_t k = 0; k < n; ++k) {
      const std::int32_t other = hull.neighbour(f, k);
      std::vector<std::int32_t> theirs(hull.vertices(other).begin(), hull.vertices(other).end());
      std::vector<std::int32_t> ours(hull.vertices(f).begin(), hull.vertices(f).end());
      for (const std::int32_t v : theirs) {
        if (std::ranges::find(ours, v) == ours.end()) ours[k] = v;
      }
      int sign = -signs[static_cast<std::size_t>(f)];
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j =
            static_cast<std::size_t>(std::ranges::find(theirs, ours[i]) - theirs.begin());
        if (j != i) {
          std::swap(theirs[i], theirs[j]);
          sign = -sign;
        }
      }
      int& known = signs[static_cast<std::size_t>(other)];
      if (known == 0) queue.push_back(other);
      EXPECT_TRUE(known == 0 || known == sign);
      known = sign;
    }
  }
  EXPECT_EQ(queue.size(), hull.facet_count());
  return signs;
}

// What the surface encloses: the signed cones from the centre over the facets. Folds of coplanar
// facets cancel.
template <std::size_t N>
double volume(const pdg::SimplicialHull<N>& hull, const std::vector<double>& centre) {
  const std::vector<int> signs = orientations(hull);
  double sum = 0.0;
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(hull.id_bound()); ++f) {
    if (!hull.alive(f)) continue;
    std::vector<std::vector<double>> rows;
    for (const std::int32_t v : hull.vertices(f)) {
      std::vector<double>& row = rows.emplace_back(hull.point(v).begin(), hull.point(v).end());
      for (std::size_t i = 0; i < row.size(); ++i) row[i] -= centre[i];
    }
    sum += signs[static_cast<std::size_t>(f)] * determinant(rows);
  }
  return std::abs(sum) / std::tgamma(static_cast<double>(hull.dimension()) + 1.0);
}

Points random_points(const std::size_t n, const std::size_t count, const unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Points points(count, std::vector<double>(n));
  for (auto& p : points) {
    for (double& x : p) x = normal(random);
  }
  return points;
}

// {-1, 0, 1}^n: vertices, and points within faces of every dimension.
Points grid(const std::size_t n) {
  Points points(1);
  for (std::size_t i = 0; i < n; ++i) {
    Points longer;
    for (const auto& p : points) {
      for (const double x : {-1.0, 0.0, 1.0}) {
        longer.push_back(p);
        longer.back().push_back(x);
      }
    }
    points = longer;
  }
  return points;
}

template <std::size_t N>
void check_dimension() {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Points points = random_points(N, 40, seed);
    const auto hull = hull_of<N>(points);
    expect_closed(hull);
    expect_convex(hull, points);
    const auto dynamic = hull_of<0>(points);
    ASSERT_EQ(dynamic.id_bound(), hull.id_bound());
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(hull.id_bound()); ++f) {
      ASSERT_TRUE(std::ranges::equal(hull.normal(f), dynamic.normal(f)));
      ASSERT_TRUE(std::ranges::equal(hull.vertices(f), dynamic.vertices(f)));
    }
  }
}

TEST(SimplicialHull, RandomPoints) {
  check_dimension<2>();
  check_dimension<3>();
  check_dimension<4>();
  check_dimension<5>();
  check_dimension<6>();
}

TEST(SimplicialHull, OneDimension) {
  const auto hull = hull_of<0>({{0.0}, {1.0}, {3.0}, {-2.0}, {0.5}});
  expect_closed(hull);
  EXPECT_EQ(hull.facet_count(), 2U);
  expect_convex(hull, {{3.0}, {-2.0}});
}

template <std::size_t N>
void check_grid() {
  Points points = grid(N);
  std::mt19937_64 random(N);
  for (int round = 0; round < 3; ++round) {
    std::ranges::shuffle(points, random);
    const Points ordered = with_simplex_first(points);
    const auto hull = hull_of<N>(ordered);
    expect_closed(hull);
    expect_convex(hull, ordered);
    // All of it lies inside the cube, so the same volume means the same body.
    std::vector<double> centre(N);
    for (std::size_t k = 0; k <= N; ++k) {
      for (std::size_t i = 0; i < N; ++i) centre[i] += ordered[k][i] / (N + 1);
    }
    EXPECT_NEAR(volume(hull, centre), std::pow(2.0, N), 1e-9);
  }
}

TEST(SimplicialHull, PointsOfAGrid) {
  check_grid<2>();
  check_grid<3>();
  check_grid<4>();
  check_grid<5>();
}

TEST(SimplicialHull, CrossPolytopeTurnedAndDoubled) {
  constexpr std::size_t kN = 6;
  const Points frame = random_points(kN, kN, 5);
  // Gram-Schmidt.
  Points axes;
  for (auto v : frame) {
    for (const auto& a : axes) {
      const double along = std::inner_product(v.begin(), v.end(), a.begin(), 0.0);
      for (std::size_t i = 0; i < kN; ++i) v[i] -= along * a[i];
    }
    const double length = std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
    for (double& x : v) x /= length;
    axes.push_back(v);
  }
  Points points = axes;
  for (const auto& a : axes) {
    points.push_back(a);
    for (double& x : points.back()) x = -x;
  }
  const Points once = points;
  points.insert(points.end(), once.begin(), once.end());
  const Points ordered = with_simplex_first(points);
  const auto hull = hull_of<kN>(ordered);
  expect_closed(hull);
  expect_convex(hull, points);
  EXPECT_GE(hull.facet_count(), 64U);
}

TEST(SimplicialHull, PointsInsideChangeNothing) {
  Points points = random_points(3, 30, 9);
  const auto before = hull_of<3>(points);
  points.push_back({0.0, 0.0, 0.0});
  const auto after = hull_of<3>(points);
  EXPECT_EQ(before.facet_count(), after.facet_count());
  EXPECT_EQ(before.id_bound(), after.id_bound());
}

}  // namespace
