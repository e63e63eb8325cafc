// Gouraud's colours along a segment on a line.
#pragma once

#include "core/vsg/blocks.hpp"

namespace spanline {

// One channel (or a weighted sum of them) of an edge at a line, Q8.7.
inline std::int32_t on_line(const EdgeShade& edge, int channel, std::uint16_t line) {
  const std::int32_t down = line + 2048 - edge.first_line_from_top;
  return edge.color[channel] + edge.step[channel] * down;
}

// A colour channel along a segment, Q8.16. Its step is cut off towards zero, so it stays between the values at the
// segment's ends, which are colours: no clamping.
struct Ramp {
  std::uint32_t value, step;

  // from and to: Q8.7 at the segment's first column and one past its last; `skipped` columns of it are not shown.
  Ramp(std::int32_t from, std::int32_t to, std::int32_t width, std::int32_t skipped) {
    const std::int32_t slope = (to - from) * 512 / width;
    value = static_cast<std::uint32_t>(from * 512 + slope * skipped);
    step = static_cast<std::uint32_t>(slope);
  }
};

// Where a segment lies on the line just made.
inline std::int32_t first_column(const SegmentBlock& segment) { return segment.half[0].stepped_back().column; }
inline std::int32_t width_of(const SegmentBlock& segment) {
  return segment.half[1].stepped_back().column - first_column(segment);
}

}  // namespace spanline
