// Depth along a line as a function of the facet alone: never of a sample's place, of the band or of the line before.
// A triangle's is its plane; any other facet's runs straight between its own two edges on the line (seed 1, chapter V),
// which is the plane where there is one.
#pragma once

#include "core/geom/facet.hpp"
#include "core/vsg/blocks.hpp"

namespace spanline {

// A triangle's depth as a ramp for line 0 and its step a line, Q16.13 modulo 2^32. The gradients are rounded once
// (2^-14 a pixel) and anchored at a pixel of the screen, so on a screen of w x h pixels the error stays below (w + h) *
// 2^-14 + 2^-13 units of depth (of 65536); for a small triangle it stays below half a unit (see depth.cpp).
struct DepthPlane {
  DepthRamp ramp;
  std::uint32_t down = 0;

  DepthRamp on_line(std::int32_t line) const {
    return {ramp.at_zero + down * static_cast<std::uint32_t>(line), ramp.slope};
  }
};
// Likewise of another value, with as many fraction bits: kRampShift of one of kDepthBits, to 16 of one of 13 bits.
DepthPlane value_plane(const ScreenXY (&at)[3], const std::uint32_t (&value)[3], int bits, const Screen& screen);
inline DepthPlane depth_plane(const ScreenXY (&at)[3], const std::uint32_t (&depth)[3], const Screen& screen) {
  return value_plane(at, depth, kRampShift, screen);
}

// The plane of a face of the scene, a triangle that the view does not clip. Makes it the reader's current face.
DepthPlane face_plane(FacetReader& reader, std::uint16_t face, const Screen& screen);

// The ramp between two edges whose columns differ, from their exact places on the line; error below 2^-6 units.
DepthRamp depth_between(const SegmentHalf& left, const SegmentHalf& right);

}  // namespace spanline
