// Depth as an exact plane over the grid. A clipped polygon stays in its plane, so depth is not stored at the vertices
// but asked for: equal places have equal depth in every piece, however often a polygon has been cut, and no error adds
// up. Coefficients are whole, so which of two planes is nearer at a grid point is one exact 64-bit comparison.
#pragma once

#include "core/area/predicates.hpp"

namespace spanline::area {

inline constexpr int kPlaneBits = 16;                     // fraction bits of a plane's value
inline constexpr std::int32_t kMaxDepth = (1 << 24) - 1;  // depth is Q16.8 as FacetVertex has it, larger is nearer
inline constexpr std::int64_t kMaxGradient = std::int64_t{1} << 42;  // of a plane that is hardly seen from the side

// value(p) = along_x · x + along_y · y + at_origin, in 2^-kPlaneBits of a depth.
struct Plane {
  std::int64_t along_x = 0, along_y = 0, at_origin = 0;

  constexpr std::int64_t value(GridPoint p) const { return along_x * p.x + along_y * p.y + at_origin; }
  static_assert(2 * 2 * (kMaxGradient >> 32) * kMaxCoordinate < INT32_MAX / 4, "values and their differences fit");

  // To the nearest, halves upwards.
  constexpr std::int64_t depth(GridPoint p) const { return shift_round(value(p), kPlaneBits); }

  static constexpr Plane level(std::int32_t depth) { return {0, 0, std::int64_t{depth} << kPlaneBits}; }

  // Through three points not on one line, with depths within 0 … kMaxDepth. Gradients are rounded once, to 2^-16 depth
  // a unit, and exact where the plane's own are that fine; the plane goes through the first point. A rise has 24 bits
  // and a difference 17, so a gradient's numerator fits 24 + 17 + 1 + kPlaneBits + 1 = 59.
  static constexpr Plane through(const GridPoint (&at)[3], const std::int32_t (&depth)[3]) {
    std::int64_t whole = orientation(at[0], at[1], at[2]);
    const std::int64_t rise1 = depth[1] - depth[0], rise2 = depth[2] - depth[0];
    std::int64_t x = rise1 * (at[2].y - at[0].y) - rise2 * (at[1].y - at[0].y);
    std::int64_t y = rise2 * (at[1].x - at[0].x) - rise1 * (at[2].x - at[0].x);
    if (whole < 0) {
      whole = -whole;
      x = -x;
      y = -y;
    }
    Plane plane;
    plane.along_x = gradient(x, whole);
    plane.along_y = gradient(y, whole);
    plane.at_origin = (std::int64_t{depth[0]} << kPlaneBits) - plane.along_x * at[0].x - plane.along_y * at[0].y;
    return plane;
  }

 private:
  static constexpr std::int64_t gradient(std::int64_t rise, std::int64_t run) {
    const std::int64_t value = round_div<std::int64_t>(rise * (1 << kPlaneBits), run);
    return value > kMaxGradient ? kMaxGradient : value < -kMaxGradient ? -kMaxGradient : value;
  }
};

// A line through the grid: value(p) = 0 on it, and the sides are told apart by the sign. Points whose value is at most
// `reach` off 0 count as on the line.
struct Line {
  std::int64_t along_x = 0, along_y = 0, at_origin = 0;
  std::int64_t reach = 0;

  constexpr std::int64_t value(GridPoint p) const { return along_x * p.x + along_y * p.y + at_origin; }
  constexpr int side(GridPoint p) const {
    const std::int64_t v = value(p);
    return v > reach ? 1 : v < -reach ? -1 : 0;
  }
};

// Where two planes cross; positive where `a` is nearer. What half a unit in x and y does to a point on the line counts
// as on it.
constexpr Line crossing_line(const Plane& a, const Plane& b) {
  Line line{a.along_x - b.along_x, a.along_y - b.along_y, a.at_origin - b.at_origin};
  const std::int64_t x = line.along_x < 0 ? -line.along_x : line.along_x;
  const std::int64_t y = line.along_y < 0 ? -line.along_y : line.along_y;
  line.reach = (x + y) / 2;
  return line;
}

// Where low → high, whose ends lie strictly on different sides of a line, meets it: the nearest grid point. low < high,
// so that both polygons that share an edge find the same point.
constexpr GridPoint meeting(GridPoint low, GridPoint high, const Line& line) {
  std::int64_t before = line.value(low), whole = before - line.value(high);
  if (whole < 0) {
    before = -before;
    whole = -whole;
  }
  // 17 bits of a difference leave 45 for the share of the way.
  while (whole >= std::int64_t{1} << 44) {
    before >>= 1;
    whole >>= 1;
  }
  return {static_cast<std::int16_t>(low.x + round_div<std::int64_t>((high.x - low.x) * before, whole)),
          static_cast<std::int16_t>(low.y + round_div<std::int64_t>((high.y - low.y) * before, whole))};
}

}  // namespace spanline::area
