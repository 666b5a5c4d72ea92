#include "cover.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "pdg/native/geometry/predicates.hpp"

namespace pdg {
namespace {

constexpr std::size_t at(const Index i) {
  return static_cast<std::size_t>(i);
}

// Twice the area, in plain doubles: used to choose between growths, never to admit one.
double twice_area(const std::vector<Vec2>& points, const Part& part) {
  const Vec2 base = points[at(part.front())];
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    sum += cross(points[at(part[i])] - base, points[at(part[i + 1])] - base);
  }
  return sum;
}

// Which part lies left of each directed edge.
class EdgeOwners {
 public:
  explicit EdgeOwners(const std::vector<Part>& parts) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const Part& part = parts[p];
      for (std::size_t i = 0; i < part.size(); ++i) {
        owners_.emplace(key(part[i], part[(i + 1) % part.size()]), p);
      }
    }
  }

  const std::size_t* find(const Index from, const Index to) const {
    const auto found = owners_.find(key(from, to));
    return found == owners_.end() ? nullptr : &found->second;
  }

 private:
  static std::uint64_t key(const Index from, const Index to) {
    return (static_cast<std::uint64_t>(from) << 32U) | static_cast<std::uint64_t>(to);
  }
  std::unordered_map<std::uint64_t, std::size_t> owners_;
};

// Vertices p, u, v, q in a row on the growing part; the neighbour lies right of u -> v.
struct Gate {
  Index p;
  Index u;
  Index v;
  Index q;
};

// The neighbour's vertices between u and v that the part can take in and stay convex: those not
// right of p -> u and not right of v -> q. They are a subset of a convex ring, in its order, so
// their hull with u and v lies in the neighbour, and the union is convex because it turns left or
// goes straight at u and at v. Empty when u or v is a collinear vertex of the part.
Part absorbable(const std::vector<Vec2>& points, const Gate& gate, const Part& neighbour) {
  const auto turn = [&](const Index a, const Index b, const Index c) {
    return orient2d(points[at(a)], points[at(b)], points[at(c)]);
  };
  Part taken;
  if (turn(gate.p, gate.u, gate.v) <= 0 || turn(gate.u, gate.v, gate.q) <= 0) return taken;
  const auto begin = std::find(neighbour.begin(), neighbour.end(), gate.u) - neighbour.begin();
  const std::size_t n = neighbour.size();
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Index w = neighbour[(static_cast<std::size_t>(begin) + k) % n];
    if (turn(gate.u, gate.v, w) < 0 && turn(gate.p, gate.u, w) >= 0 &&
        turn(gate.v, gate.q, w) >= 0) {
      taken.push_back(w);
    }
  }
  return taken;
}

// Takes in, again and again, the absorbable piece of largest area.
Part grow(const std::vector<Vec2>& points, const std::vector<Part>& parts, const EdgeOwners& owners,
          Part part) {
  for (;;) {
    const std::size_t n = part.size();
    Part best;
    std::size_t best_edge = 0;
    double best_area = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const Gate gate{part[(i + n - 1) % n], part[i], part[(i + 1) % n], part[(i + 2) % n]};
      const std::size_t* neighbour = owners.find(gate.v, gate.u);
      if (neighbour == nullptr) continue;
      Part taken = absorbable(points, gate, parts[*neighbour]);
      if (taken.empty()) continue;
      Part gain = taken;
      gain.push_back(gate.v);
      gain.insert(gain.begin(), gate.u);
      const double area = std::abs(twice_area(points, gain));
      if (best.empty() || area > best_area) {
        best = std::move(taken);
        best_edge = i;
        best_area = area;
      }
    }
    if (best.empty()) return part;
    part.insert(part.begin() + static_cast<std::ptrdiff_t>(best_edge) + 1, best.begin(),
                best.end());
  }
}

// Whether the convex `inner` lies in the convex `outer`; exact.
bool contains(const std::vector<Vec2>& points, const Part& outer, const Part& inner) {
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Vec2 a = points[at(outer[i])];
    const Vec2 b = points[at(outer[(i + 1) % outer.size()])];
    for (const Index w : inner) {
      if (orient2d(a, b, points[at(w)]) < 0) return false;
    }
  }
  return true;
}

}  // namespace

// The grown parts are taken largest first; each answers for the given parts it contains, and is
// kept if it answers for one that no earlier part does.
std::vector<Part> grow_to_cover(const std::vector<Vec2>& points, const std::vector<Part>& parts) {
  const EdgeOwners owners(parts);
  std::vector<Part> grown;
  std::vector<double> areas;
  grown.reserve(parts.size());
  for (const Part& part : parts) {
    grown.push_back(grow(points, parts, owners, part));
    areas.push_back(twice_area(points, grown.back()));
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
  });
  std::vector<Part> cover;
  std::vector<std::uint8_t> covered(parts.size(), 0);
  for (const std::size_t g : order) {
    if (covered[g] != 0) continue;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (covered[p] == 0 && contains(points, grown[g], parts[p])) covered[p] = 1;
    }
    covered[g] = 1;
    cover.push_back(grown[g]);
  }
  return cover;
}

}  // namespace pdg
