// Random rounds, each as large as all before it together: the expected number of flips is then
// linear whatever the points (Amenta, Choi and Rote, Incremental Constructions con BRIO, 2003).
// Within a round the points follow a Hilbert curve, so that each lies near the one before it.
#include "insertion_order.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "tuning.hpp"

namespace pdg {
namespace {

// A SplitMix64 step: a fixed "random" number of an index.
std::uint64_t scrambled(const std::uint64_t index) {
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

// Position along the Hilbert curve of a square of 2^bits cells a side.
std::uint64_t along_curve(std::uint32_t x, std::uint32_t y, const int bits) {
  std::uint64_t position = 0;
  for (int bit = bits - 1; bit >= 0; --bit) {
    const std::uint32_t in_x = (x >> static_cast<unsigned>(bit)) & 1U;
    const std::uint32_t in_y = (y >> static_cast<unsigned>(bit)) & 1U;
    position = 4 * position + ((3 * in_x) ^ in_y);
    if (in_y != 0) continue;
    if (in_x == 1) {
      x = ~x;
      y = ~y;
    }
    std::swap(x, y);
  }
  return position;
}

// The place of each point in the order by (y, x).
std::vector<std::uint32_t> ranks_by_y(const std::vector<Vec2>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](const std::uint32_t a, const std::uint32_t b) {
    return std::tie(points[a].y, points[a].x) < std::tie(points[b].y, points[b].x);
  });
  std::vector<std::uint32_t> ranks(points.size());
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) ranks[order[rank]] = rank;
  return ranks;
}

}  // namespace

// The curve runs through the ranks of the coordinates instead of the coordinates themselves, which
// may crowd at any scale.
std::vector<Index> insertion_order(const std::vector<Vec2>& sorted_points, const Index first) {
  struct Place {
    int rounds_from_last;
    std::uint64_t position;
    Index point;
  };
  const std::size_t n = sorted_points.size();
  const auto bits = static_cast<int>(std::bit_width(n));
  const auto rounds = static_cast<int>(std::bit_width(n / static_cast<std::size_t>(kSmallRound)));
  const std::vector<std::uint32_t> y_ranks = ranks_by_y(sorted_points);
  std::vector<Place> places;
  for (auto i = static_cast<std::size_t>(first); i < n; ++i) {
    const int round = std::min(rounds, std::countl_zero(scrambled(i)));
    places.push_back({round, along_curve(static_cast<std::uint32_t>(i), y_ranks[i], bits),
                      static_cast<Index>(i)});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.rounds_from_last != b.rounds_from_last
               ? a.rounds_from_last > b.rounds_from_last
               : std::tie(a.position, a.point) < std::tie(b.position, b.point);
  });
  std::vector<Index> order;
  order.reserve(places.size());
  for (const Place& place : places) order.push_back(place.point);
  return order;
}

}  // namespace pdg
