// What the assemblies that begin edges on cores with Thumb-2 have in common.
#pragma once

#include "core/vsg/active_edge.hpp"

namespace spanline {

// FromVertex::run(): the slope of an edge that runs so far across, in the upper half, and down; on to `far` where it is
// not short. Takes `across`; `free` may be `slope`.
#define SPANLINE_EDGE_SLOPE                              \
  "\n  .macro edge_slope slope, across, down, free, far" \
  "\n  eor \\free, \\across, \\across, asr #31"          \
  "\n  orr \\free, \\down, \\free, lsr #17"              \
  "\n  cmp \\free, #512"                                 \
  "\n  bhs \\far"                                        \
  "\n  lsls \\across, \\across, #4"                      \
  "\n  sdiv \\slope, \\across, \\down"                   \
  "\n  subs \\slope, #1"                                 \
  "\n  .endm\n"

static_assert(kSubpixels == 16 && FromVertex::kShort == 512 && ActiveEdge::kFraction == 20);
static_assert(sizeof(ActiveEdge) == 16 && ActiveEdge::kOneLine == 1u << 17);

}  // namespace spanline
