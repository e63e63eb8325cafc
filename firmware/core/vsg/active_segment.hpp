#pragma once

#include "core/vsg/blocks.hpp"

namespace spanline {

// An entry of the active list (III.F): a segment taken from the X-sort list on this line that reaches into spans to
// come. It holds all that the comparator needs, so that a span looks at it without touching the segment block.
struct ActiveSegment {
  std::uint16_t segment = 0;  // 0: none, the background
  std::uint16_t polygon = 0;
  std::uint16_t left : 15 = 0;  // columns on this line, clipped to the screen
  std::uint16_t fresh : 1 = 0;  // taken in the present span: its block is in the comparator's registers still
  std::uint16_t right : 15 = 0;
  std::uint16_t has_ramp : 1 = 0;
  DepthRamp ramp;
};
static_assert(sizeof(ActiveSegment) == 16);

}  // namespace spanline
