// Plane vectors. Plain doubles, no invariants.
#pragma once

#include <cmath>

namespace pdg {

struct Vec2 {
  double x = 0.0;
  double y = 0.0;
};

constexpr Vec2 operator+(const Vec2 a, const Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(const Vec2 a, const Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator-(const Vec2 a) {
  return {-a.x, -a.y};
}
constexpr Vec2 operator*(const double s, const Vec2 a) {
  return {s * a.x, s * a.y};
}
constexpr bool operator==(const Vec2 a, const Vec2 b) {
  return a.x == b.x && a.y == b.y;
}

constexpr double dot(const Vec2 a, const Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
constexpr double cross(const Vec2 a, const Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

// a turned by +90 degrees.
constexpr Vec2 perp(const Vec2 a) {
  return {-a.y, a.x};
}

inline double norm(const Vec2 a) {
  return std::sqrt(a.x * a.x + a.y * a.y);
}

}  // namespace pdg
