// Depth at every vertex of the output. A clipped polygon stays in its plane, so depth is not stored but asked for:
// equal places have equal depth in both lists, however often a polygon has been cut, and no error adds up.
#pragma once

#include "core/area/predicates.hpp"

namespace spanline::area {

// A plane over the grid: three points not on one line, and their depths within 0 … 65535.
struct DepthPlane {
  GridPoint at[3];
  std::int32_t depth[3];
};

// The depth at `p`, to the nearest, halves upwards; outside of the three points the plane goes on. A depth has 17 bits
// with its sign and an orientation 35, so the sum of two products fits 53.
constexpr std::int64_t depth_at(const DepthPlane& plane, GridPoint p) {
  const std::int64_t whole = orientation(plane.at[0], plane.at[1], plane.at[2]);
  const std::int64_t rise = (plane.depth[1] - plane.depth[0]) * orientation(plane.at[0], p, plane.at[2]) +
                            (plane.depth[2] - plane.depth[0]) * orientation(plane.at[0], plane.at[1], p);
  const std::int64_t share = whole < 0 ? -rise : rise, divisor = whole < 0 ? -whole : whole;
  return plane.depth[0] + floor_div<std::int64_t>(2 * share + divisor, 2 * divisor);
}

}  // namespace spanline::area
