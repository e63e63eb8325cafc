// Path data as in SVG 1.1, section 8.3: what drawing programs and font tools write for outlines.
#pragma once

#include <string_view>
#include <vector>

#include "assetc/json_node.hpp"
#include "assetc/vec.hpp"

namespace spanline::host {

// One subpath as cubic Bezier pieces that share their ends: 3 n + 1 points, or 3 n where it is closed. z is 0.
struct PathContour {
  std::vector<Vec3> points;
  bool closed = false;
};

// Reads the text of `node`: M, L, H, V, C, S, Q, T and Z, absolute and relative; elliptical arcs are refused. Straight
// pieces have their control points at thirds, quadratic ones are raised in degree. Closing adds a straight piece where
// the ends differ. Fails with the offset of what it does not understand, and where a subpath has no piece.
std::vector<PathContour> read_svg_path(const JsonNode& node);

}  // namespace spanline::host
