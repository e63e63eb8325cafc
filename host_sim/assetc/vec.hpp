// Vectors and placements in double: what the host computes with before anything becomes a record.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace spanline::host {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(double k, Vec3 a) { return {k * a.x, k * a.y, k * a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) { return std::hypot(a.x, a.y, a.z); }
inline double largest(Vec3 a) { return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}); }
inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// `a` at length 1, or `fallback` where it has no direction.
inline Vec3 unit_or(Vec3 a, Vec3 fallback) {
  const double size = largest(a);
  if (!(size > 0)) return fallback;
  const Vec3 scaled = (1 / size) * a;  // squares neither overflow nor vanish
  return (1 / length(scaled)) * scaled;
}

// World = rows * point + translation.
struct Placement {
  std::array<Vec3, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 translation;

  Vec3 turn(Vec3 p) const { return {dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)}; }
  Vec3 operator()(Vec3 p) const { return turn(p) + translation; }
};

// An axis-parallel box; empty until the first point.
struct Box {
  Vec3 low{1, 1, 1}, high{-1, -1, -1};

  bool empty() const { return low.x > high.x; }
  void add(Vec3 p) {
    if (empty()) low = high = p;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void add(const Box& other) {
    if (other.empty()) return;
    add(other.low);
    add(other.high);
  }
  Vec3 centre() const { return 0.5 * (low + high); }
  Vec3 half() const { return 0.5 * (high - low); }
};

struct Sphere {
  Vec3 centre;
  double radius = 0;
};

}  // namespace spanline::host
