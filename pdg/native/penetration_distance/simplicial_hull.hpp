// The convex hull of points of R^n as a closed surface of simplices, grown point by point ([GFE]
// Propositions 3 and 4).
//
// Why it does not break down where points are coplanar, as those of symmetric sets are: a facet is
// kept as (m, delta), the plane m.x = delta, scaled so that m.c = delta - 1 for a point c inside. A
// new facet stands on the horizon ridge between a facet F that the point s sees (f = m_F.s -
// delta_F > 0) and one, G, that it does not (g = m_G.s - delta_G <= 0). Its plane is the one of the
// pencil of F and G that meets s,
//     (m, delta) = (f (m_G, delta_G) - g (m_F, delta_F)) / (f - g),
// a convex combination, so the errors of planes never grow by it, however close to 0 f and g are;
// it costs O(n). A point that is above a plane by kSeenHeight or less (g > 0 then counts as 0) does
// not see it, so that coplanar points make few facets. And whatever is decided about f and g, the
// visible facets are a connected part of the surface and what replaces them closes the hole: the
// surface stays closed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "pdg/native/tolerances.hpp"

namespace pdg {

// N: the dimension at compile time (loops are unrolled), or 0 for one given at run time.
template <std::size_t N>
class SimplicialHull {
 public:
  using Id = std::int32_t;

  // The simplex of n + 1 points (rows), affinely independent, with the outward planes of its
  // facets: row j of `planes` is (m, delta) of the facet opposite point j, in the scaling above.
  SimplicialHull(std::size_t n, std::span<const double> points, std::span<const double> planes);

  [[nodiscard]] std::size_t dimension() const { return N != 0 ? N : n_; }
  [[nodiscard]] std::size_t facet_count() const { return live_; }
  // Ids of facets are below this; some are dead.
  [[nodiscard]] std::size_t id_bound() const { return alive_.size(); }
  [[nodiscard]] bool alive(const Id facet) const { return alive_[at(facet)] != 0; }
  // Which facets an id has meant so far: a dead facet's id is used again.
  [[nodiscard]] std::uint32_t generation(const Id facet) const { return generation_[at(facet)]; }

  [[nodiscard]] std::span<const double> normal(const Id facet) const {
    return {planes_.data() + at(facet) * (dimension() + 1), dimension()};
  }
  [[nodiscard]] double offset(const Id facet) const {
    return planes_[at(facet) * (dimension() + 1) + dimension()];
  }
  [[nodiscard]] std::span<const Id> vertices(const Id facet) const {
    return {corners_.data() + at(facet) * dimension(), dimension()};
  }
  [[nodiscard]] std::span<const double> point(const Id vertex) const {
    return {points_.data() + at(vertex) * dimension(), dimension()};
  }
  // The facet across the ridge opposite the k-th vertex.
  [[nodiscard]] Id neighbour(const Id facet, const std::size_t k) const {
    return mates_[half(facet, k)] / static_cast<Id>(dimension());
  }

  // m.x - delta.
  [[nodiscard]] double height(Id facet, std::span<const double> x) const;

  // Takes in a point that `seen` sees: the facets seen are replaced by those that join the point to
  // their horizon, and the new ones returned (until the next call). Empty, and nothing done, if
  // height(seen, s) <= kSeenHeight. Throws std::length_error beyond 2^31 / n facets.
  std::span<const Id> add(std::span<const double> s, Id seen);

 private:
  static std::size_t at(const Id id) { return static_cast<std::size_t>(id); }
  // A ridge has two halves, one a facet: facet * n + index of the vertex opposite.
  [[nodiscard]] std::size_t half(const Id facet, const std::size_t k) const {
    return at(facet) * dimension() + k;
  }

  void find_visible(std::span<const double> s, Id seen);
  Id new_facet();
  void stand_on(Id horizon_half, Id apex);
  void join(Id horizon_half, Id facet);

  std::size_t n_;
  std::size_t live_ = 0;
  std::vector<double> points_;
  std::vector<double> planes_;  // m, delta
  std::vector<Id> corners_;
  // The other half of each half's ridge. While a point is added, the halves of visible facets on
  // the horizon hold -1 - (half of the new facet that stands there).
  std::vector<Id> mates_;
  std::vector<std::uint8_t> alive_;
  std::vector<std::uint32_t> generation_;
  std::vector<Id> free_;
  // State of the addition that is under way:
  std::vector<std::uint32_t> visit_;  // the addition that last asked the facet
  std::uint32_t round_ = 0;
  std::vector<double> heights_;
  std::vector<Id> visible_;
  std::vector<Id> horizon_;  // halves of visible facets
  std::vector<Id> made_;
};

template <std::size_t N>
SimplicialHull<N>::SimplicialHull(const std::size_t n, const std::span<const double> points,
                                  const std::span<const double> planes)
    : n_(n), points_(points.begin(), points.end()) {
  // Facet j has the points but j in order, so point p is its vertex p - (p > j); across the ridge
  // opposite p lies facet p.
  for (std::size_t j = 0; j <= n; ++j) {
    const Id facet = new_facet();
    for (std::size_t i = 0; i <= n; ++i) planes_[j * (n + 1) + i] = planes[j * (n + 1) + i];
    for (std::size_t p = 0; p <= n; ++p) {
      if (p == j) continue;
      const std::size_t k = p - (p > j ? 1 : 0);
      corners_[half(facet, k)] = static_cast<Id>(p);
      mates_[half(facet, k)] = static_cast<Id>(half(static_cast<Id>(p), j - (j > p ? 1 : 0)));
    }
  }
}

template <std::size_t N>
double SimplicialHull<N>::height(const Id facet, const std::span<const double> x) const {
  const double* const plane = planes_.data() + at(facet) * (dimension() + 1);
  double sum = -plane[dimension()];
  for (std::size_t i = 0; i < dimension(); ++i) sum += plane[i] * x[i];
  return sum;
}

template <std::size_t N>
auto SimplicialHull<N>::new_facet() -> Id {
  ++live_;
  if (!free_.empty()) {
    const Id facet = free_.back();
    free_.pop_back();
    alive_[at(facet)] = 1;
    ++generation_[at(facet)];
    return facet;
  }
  const Id facet = static_cast<Id>(alive_.size());
  alive_.push_back(1);
  generation_.push_back(0);
  visit_.push_back(0);
  heights_.push_back(0.0);
  planes_.resize(planes_.size() + dimension() + 1);
  corners_.resize(corners_.size() + dimension());
  mates_.resize(mates_.size() + dimension());
  return facet;
}

template <std::size_t N>
void SimplicialHull<N>::find_visible(const std::span<const double> s, const Id seen) {
  ++round_;
  visible_.clear();
  horizon_.clear();
  visit_[at(seen)] = round_;
  heights_[at(seen)] = height(seen, s);
  if (!(heights_[at(seen)] > kSeenHeight)) return;
  visible_.push_back(seen);
  for (std::size_t next = 0; next < visible_.size(); ++next) {
    const Id facet = visible_[next];
    for (std::size_t k = 0; k < dimension(); ++k) {
      const Id other = neighbour(facet, k);
      if (visit_[at(other)] != round_) {
        visit_[at(other)] = round_;
        heights_[at(other)] = height(other, s);
        if (heights_[at(other)] > kSeenHeight) visible_.push_back(other);
      }
      if (!(heights_[at(other)] > kSeenHeight)) horizon_.push_back(static_cast<Id>(half(facet, k)));
    }
  }
}

// The facet that joins the apex to the horizon ridge, in the place of the visible facet there, and
// its plane.
template <std::size_t N>
void SimplicialHull<N>::stand_on(const Id horizon_half, const Id apex) {
  const std::size_t n = dimension();
  const Id outer_half = mates_[at(horizon_half)];
  const Id facet = new_facet();
  const Id visible = horizon_half / static_cast<Id>(n);
  const Id outer = outer_half / static_cast<Id>(n);
  const std::size_t k = at(horizon_half) % n;
  for (std::size_t i = 0; i < n; ++i) corners_[half(facet, i)] = corners_[half(visible, i)];
  for (std::size_t i = 0; i < n; ++i) mates_[half(facet, i)] = -1;
  corners_[half(facet, k)] = apex;
  mates_[half(facet, k)] = outer_half;
  mates_[at(outer_half)] = static_cast<Id>(half(facet, k));
  mates_[at(horizon_half)] = -1 - static_cast<Id>(half(facet, k));

  const double f = heights_[at(visible)];
  const double g = std::min(heights_[at(outer)], 0.0);
  const double share = f / (f - g);  // in (0, 1]: of the outer facet
  const double* const m_f = planes_.data() + at(visible) * (n + 1);
  const double* const m_g = planes_.data() + at(outer) * (n + 1);
  double* const m = planes_.data() + at(facet) * (n + 1);
  for (std::size_t i = 0; i <= n; ++i) m[i] = share * m_g[i] + (1.0 - share) * m_f[i];
  made_.push_back(facet);
}

// Finds the new facets beside a new one. It stands on a ridge of the visible facet `current`; that
// ridge's face without the vertex i is turned about through visible facets until the horizon is met
// again, and the new facet that stands there shares with ours the ridge of the face and the apex.
template <std::size_t N>
void SimplicialHull<N>::join(const Id horizon_half, const Id facet) {
  const std::size_t n = dimension();
  const std::size_t apex = at(horizon_half) % n;
  for (std::size_t i = 0; i < n; ++i) {
    if (mates_[half(facet, i)] >= 0) continue;
    Id current = horizon_half / static_cast<Id>(n);
    std::size_t leave = i;    // the vertex of `current` opposite the ridge that is crossed next
    std::size_t kept = apex;  // its other vertex that is not of the face
    Id across = mates_[half(current, leave)];
    while (across >= 0) {
      const Id turn_about = corners_[half(current, kept)];
      current = across / static_cast<Id>(n);
      kept = at(across) % n;
      leave = 0;
      while (corners_[half(current, leave)] != turn_about) ++leave;
      across = mates_[half(current, leave)];
    }
    const Id beside = (-1 - across) / static_cast<Id>(n);
    mates_[half(facet, i)] = static_cast<Id>(half(beside, kept));
    mates_[half(beside, kept)] = static_cast<Id>(half(facet, i));
  }
}

template <std::size_t N>
auto SimplicialHull<N>::add(const std::span<const double> s, const Id seen) -> std::span<const Id> {
  made_.clear();
  find_visible(s, seen);
  if (visible_.empty()) return {};
  if ((id_bound() + horizon_.size()) * dimension() > std::numeric_limits<Id>::max()) {
    throw std::length_error("the hull has more facets than can be numbered");
  }
  const Id apex = static_cast<Id>(points_.size() / dimension());
  points_.insert(points_.end(), s.begin(), s.end());
  for (const Id horizon_half : horizon_) stand_on(horizon_half, apex);
  for (std::size_t i = 0; i < horizon_.size(); ++i) join(horizon_[i], made_[i]);
  for (const Id facet : visible_) alive_[at(facet)] = 0;
  free_.insert(free_.end(), visible_.begin(), visible_.end());
  live_ -= visible_.size();
  return made_;
}

}  // namespace pdg
