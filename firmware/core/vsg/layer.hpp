// Surface detail and see-through polygons over the visible segments: what is stored and what shading gets.
#pragma once

#include "core/vsg/active_segment.hpp"
#include "core/vsg/visible_span.hpp"

namespace spanline {

// What a polygon looks like where it lies over or under others, in an array beside the polygon blocks.
struct PolygonLook {
  Rgb8 color;            // where it is flat
  Rgb8 transmission;     // MaterialRecord::transmission
  std::uint16_t parent;  // the face that this is surface detail of; kNoFace: none
};
static_assert(sizeof(PolygonLook) == 8);

// One of the surfaces that a pixel shows, or shines through.
struct Layer {
  ActiveSegment* surface = nullptr;       // decides depth
  const ActiveSegment* shown = nullptr;   // what of it is seen: itself, or the topmost detail on it
  const SegmentBlock* segment = nullptr;  // of what is seen; already stepped to the next line
  const SegmentShade* shade = nullptr;    // colours along its edges, where gouraud
  std::uint16_t face = kNoFace;
  Rgb8 color{};         // where not gouraud
  Rgb8 transmission{};  // of 255; all 0: opaque, the last of its stack
};

// A run of pixels [left, right) of one line with more than one layer, the nearest first. The last one is opaque, or
// else the background shines through it.
struct LayeredSpan {
  std::uint16_t line, left, right;
  Slice<const Layer> layers;
  DepthRamp depth;  // of the nearest; set only where VsgOptions::taps

  // The nearest layer's face and depth as a span of its own; for taps, its colours are not set.
  VisibleSpan nearest() const {
    VisibleSpan span;
    span.line = line;
    span.left = left;
    span.right = right;
    span.face = layers[0].face;
    span.depth = depth;
    return span;
  }
};

// The pools for them. looks holds as many as there are polygons; the other two take as many segments as may lie over
// one pixel.
struct LayerStorage {
  PoolRef<PolygonLook> looks;
  PoolRef<ActiveSegment> aside;
  PoolRef<Layer> stack;
};

}  // namespace spanline
