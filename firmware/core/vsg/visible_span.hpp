#pragma once

#include "core/scene/scene_view.hpp"
#include "core/vsg/blocks.hpp"

namespace spanline {

// A visible segment: a run of pixels [left, right) of one line that shows one face, or the background. What shading
// consumes is the stream of these, left to right, without gap or overlap, whichever walker made them.
struct VisibleSpan {
  std::uint16_t line, left, right;
  std::uint16_t face = kNoFace;  // kNoFace: background
  bool gouraud = false;
  bool smooth = false;                    // FacetLook::smooth
  std::uint16_t payload = 0;              // what the shader gave the facet
  const SegmentBlock* segment = nullptr;  // already stepped to the next line; null for the background
  const SegmentShade* shade = nullptr;    // colours along its edges, where gouraud
  DepthRamp depth;                        // set only where VsgOptions::taps or points
};

}  // namespace spanline
