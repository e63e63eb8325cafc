// Exact plane geometry on the grid of a mesh's positions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/scene/format.hpp"

namespace spanline::host {

// In units of the grid. Areas of 16-bit positions fit 64 bits; products of areas do not.
struct GridVector {
  std::int64_t x = 0, y = 0, z = 0;

  friend GridVector operator+(GridVector a, GridVector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
};

inline GridVector operator-(const Position& a, const Position& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline GridVector cross(GridVector a, GridVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A position in the plane that is left when the normal's largest component is dropped; areas keep the normal's sign.
struct GridPoint {
  std::int64_t u, v;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

class Flattened {
 public:
  explicit Flattened(GridVector normal) {
    const std::int64_t along[3] = {normal.x, normal.y, normal.z};
    for (int i = 1; i < 3; ++i) {
      if (std::abs(along[i]) > std::abs(along[dropped_])) dropped_ = i;
    }
    flipped_ = along[dropped_] < 0;
  }
  GridPoint operator()(const Position& p) const {
    const std::int64_t all[3] = {p.x, p.y, p.z};
    const std::int64_t u = all[(dropped_ + 1) % 3], v = all[(dropped_ + 2) % 3];
    return flipped_ ? GridPoint{v, u} : GridPoint{u, v};
  }

 private:
  int dropped_ = 0;
  bool flipped_ = false;
};

// Twice the area of the triangle a, b, c; positive where it runs counter-clockwise.
inline std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

struct GridSegment {
  GridPoint from, to;

  // Whether `p` lies on it but is not an end of it.
  bool holds(GridPoint p) const {
    return turn(from, to, p) == 0 && std::min(from.u, to.u) <= p.u && p.u <= std::max(from.u, to.u) &&
           std::min(from.v, to.v) <= p.v && p.v <= std::max(from.v, to.v) && p != from && p != to;
  }
  // Whether `a` and `b` lie on different sides, neither on its line.
  bool parts(GridPoint a, GridPoint b) const {
    const std::int64_t of_a = turn(from, to, a), of_b = turn(from, to, b);
    return (of_a < 0 && of_b > 0) || (of_a > 0 && of_b < 0);
  }
};

// Whether the two have more in common than ends, or run from the same point to the same point.
inline bool collide(const GridSegment& a, const GridSegment& b) {
  if (a.holds(b.from) || a.holds(b.to) || b.holds(a.from) || b.holds(a.to)) return true;
  if (a.from == b.from && a.to == b.to) return true;
  return a.parts(b.from, b.to) && b.parts(a.from, a.to);
}

}  // namespace spanline::host
