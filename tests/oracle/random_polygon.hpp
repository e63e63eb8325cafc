// Random plane polygons of every kind the engine must fill, in whole units of a grid.
#pragma once

#include <vector>

#include "oracle/random.hpp"

namespace spanline::oracle {

struct Point {
  int x, y;
};

using Contour = std::vector<Point>;

inline constexpr int kMaxCorners = 12;

// Where a polygon lies: all its corners are within centre ± radius, clamped to -32768 … 32767.
struct Place {
  Point centre;
  int radius;
};

// A point of the unit circle in Q1.14 by the rational parameter, so that no mathematics library rounds differently:
// `turn` of 1024 a turn, not uniform in angle but monotone.
Point circle_point(int turn);

// True when no two edges touch but neighbours at their common corner: even-odd then leaves no doubt which edges bound a
// chord.
bool is_simple(const std::vector<Contour>& contours);

// 3 … 12 corners a contour; convex, star-shaped, comb, holed (2 or 3 contours), sliver or speck. `snap` puts corners on
// multiples of so many units. Always is_simple, save for triangles, which may be of zero area.
std::vector<Contour> random_polygon(Random& random, const Place& place, int snap);

}  // namespace spanline::oracle
