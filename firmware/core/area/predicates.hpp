// The exact questions that the clipper asks of the grid. Coordinates are whole and within ±kMaxCoordinate, so a
// difference has B = 17 bits, an orientation 2B + 1 = 35 and the numerator of an intersection 3B + 2 = 53: all of it
// fits 64 bits. The order of two intersections along an edge, which would need 4B bits, is never asked: hot pixels have
// an order of their own (arrangement.hpp).
#pragma once

#include <cstdint>

#include "core/fx/bits.hpp"

namespace spanline::area {

inline constexpr std::int32_t kMaxCoordinate = INT16_MAX;

// A point of the working grid. Points are ordered by x, then y.
struct GridPoint {
  std::int16_t x = 0, y = 0;
  friend constexpr bool operator==(GridPoint a, GridPoint b) { return a.x == b.x && a.y == b.y; }
  friend constexpr bool operator<(GridPoint a, GridPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

// Twice the signed area of a, b, c: positive where c lies left of a → b (y up).
constexpr std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
}

constexpr bool within(std::int32_t value, std::int32_t a, std::int32_t b) {
  return a < b ? a <= value && value <= b : b <= value && value <= a;
}

// Whether the segment a → b runs through the pixel of `centre`: the square centre ± ½, closed to the left and below,
// open to the right and above, which is the set of points that round_div takes to `centre`. a != b.
constexpr bool passes_pixel(GridPoint a, GridPoint b, GridPoint centre) {
  if (!within(centre.x, a.x, b.x) || !within(centre.y, a.y, b.y)) return false;
  const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
  const std::int64_t reach = static_cast<std::int64_t>(dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
  const std::int64_t distance = 2 * orientation(a, b, centre);
  // The corners farthest to the left and to the right of the line; a corner on an open side does not count itself.
  const bool left_is_open = dx > 0 || dy < 0, right_is_open = dx < 0 || dy > 0;
  return (left_is_open ? distance + reach > 0 : distance + reach >= 0) &&
         (right_is_open ? distance - reach < 0 : distance - reach <= 0);
}

struct Crossing {
  bool found = false;    // the interiors cross in one point
  bool rounded = false;  // and that point is not on the grid
  GridPoint at;          // it, or the nearest grid point (halves upwards)
};

constexpr bool opposite(std::int64_t a, std::int64_t b) { return (a < 0 && b > 0) || (a > 0 && b < 0); }

// Where a → b and c → d cross. Touching ends and overlaps are not crossings: their points are vertices already.
constexpr Crossing crossing(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  if (!opposite(orientation(a, b, c), orientation(a, b, d))) return {};
  const std::int64_t before = orientation(c, d, a), after = orientation(c, d, b);
  if (!opposite(before, after)) return {};
  // a + (b - a) · before / (before - after)
  const bool flip = before < after;
  const std::int64_t share = flip ? -before : before, whole = flip ? after - before : before - after;
  const std::int64_t x = (b.x - a.x) * share, y = (b.y - a.y) * share;
  return {true,
          x % whole != 0 || y % whole != 0,
          {static_cast<std::int16_t>(a.x + floor_div<std::int64_t>(2 * x + whole, 2 * whole)),
           static_cast<std::int16_t>(a.y + floor_div<std::int64_t>(2 * y + whole, 2 * whole))}};
}

}  // namespace spanline::area
