#include "farthest_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "pdg/native/tolerances.hpp"

namespace pdg {
namespace {

// |foot + s along + w|^2 = s^2 + 2 slope s + rest: parabolas that differ by a line.
struct Parabola {
  double slope = 0.0;
  double rest = 0.0;

  // The value without the common s^2.
  [[nodiscard]] double at(const double s) const { return 2.0 * slope * s + rest; }
};

Parabola parabola(const Line& line, const Vec2 w) {
  const Vec2 x = line.foot + w;
  return {dot(x, line.along), dot(x, x)};
}

Parabola highest(const std::vector<Vec2>& offsets, const Line& line, const double s) {
  Parabola best = parabola(line, offsets.front());
  for (std::size_t v = 1; v < offsets.size(); ++v) {
    const Parabola other = parabola(line, offsets[v]);
    if (other.at(s) > best.at(s)) best = other;
  }
  return best;
}

}  // namespace

double FarthestPoint::value(const Vec2 t) const {
  double most = 0.0;
  for (const Vec2 w : offsets) {
    const Vec2 x = t + w;
    most = std::max(most, dot(x, x));
  }
  return std::sqrt(most);
}

// The minimum lies between a point where the highest parabola falls and one where it rises. The
// least value of those two parabolas' maximum is taken again and again; each time a parabola is
// highest there that was not before, so it ends after as many steps as there are parabolas; further
// ones would follow roundings.
double FarthestPoint::least_on(const Line& line, const double low, const double high) const {
  if (offsets.size() == 1) {
    return std::clamp(-parabola(line, offsets.front()).slope, low, high);
  }
  Parabola falls = highest(offsets, line, low);
  if (low + falls.slope >= 0.0) return low;
  Parabola rises = highest(offsets, line, high);
  if (high + rises.slope <= 0.0) return high;
  double from = low;
  double to = high;
  double s = low;
  for (std::size_t step = 0; step < offsets.size(); ++step) {
    s = -falls.slope;
    if (falls.at(s) < rises.at(s)) {
      s = -rises.slope;
      if (rises.at(s) < falls.at(s)) {
        s = (falls.rest - rises.rest) / (2.0 * (rises.slope - falls.slope));
      }
    }
    s = std::clamp(s, from, to);
    const Parabola top = highest(offsets, line, s);
    if (top.at(s) <= std::max(falls.at(s), rises.at(s))) return s;
    const bool rising = s + top.slope > 0.0;
    (rising ? rises : falls) = top;
    (rising ? to : from) = s;
  }
  return s;
}

double FarthestPoint::reach(const double value) const {
  if (value <= radius) return 0.0;
  return std::sqrt((value - radius) * (value + radius)) * kRadiusPadding;
}

}  // namespace pdg
