// What the assembly that begins edges knows of the types it works on.
#pragma once

#include <cstddef>

#include "core/vsg/band_start.hpp"

namespace spanline {

// On cores of 32 bits.
template <typename Start>
constexpr bool band_start_layout_holds() {
  static_assert(offsetof(Start, keys) == 0 && offsetof(Start, band) == 4 && offsetof(Start, vertex) == 8);
  static_assert(offsetof(Start, line) == 12 && offsetof(Start, out) == 16 && offsetof(Start, drawn) == 20);
  static_assert(offsetof(Start, skip) == 24 && offsetof(Start, first) == 28 && offsetof(Start, count) == 32);
  static_assert(offsetof(Start, starts) == 36 && offsetof(Start, fans) == 40 && offsetof(Start, cover) == 44);
  static_assert(offsetof(Start, last) == 48 && offsetof(Start, begin) == 52 && offsetof(Start, points) == 56);
  static_assert(sizeof(BandVertex) == 8 && offsetof(BandVertex, at) == 0 && offsetof(BandVertex, vertex) == 4);
  static_assert(offsetof(BandVertex, next) == 6 && BandVertices::kFiled == 128);
  return true;
}
template <typename Start>
constexpr bool fan_start_layout_holds() {
  static_assert(offsetof(Start, points) == 0 && offsetof(Start, out) == 16, "loaded by one instruction");
  static_assert(offsetof(Start, words) == 4 && offsetof(Start, vertex) == 8 && offsetof(Start, line) == 12);
  static_assert(offsetof(Start, not_drawn) == 20 && offsetof(Start, last) == 48, "copied as they stand");
  static_assert(offsetof(Start, cover) == 24 && offsetof(Start, first) == 28 && offsetof(Start, count) == 32);
  static_assert(offsetof(Start, starts) == 36 && offsetof(Start, fans) == 40 && offsetof(Start, links) == 44);
  static_assert(offsetof(Start, begin) == 52);
  static_assert(sizeof(FanEdge) == 4 && offsetof(FanEdge, face) == 2 && FanEdge::kMostFaces == 0x8000);
  static_assert(sizeof(ActiveEdge) == 16 && ActiveEdge::kOneLine == 1u << 17 && ActiveEdge::kFraction == 20);
  static_assert(kSubpixels == 16 && FromVertex::kShort == 512 && SlopeByTable::kTallest == 256);
  static_assert(SlopeByTable::kShiftBits == 8, "a shift is by the lowest byte");
  return true;
}

}  // namespace spanline
