// What the walks in assembly know of the types they work on.
#pragma once

#include <cstddef>

#include "core/shade/smooth_brush.hpp"
#include "core/vsg/line_walk.hpp"

namespace spanline {

// On cores of 32 bits.
template <typename Colors, typename Brush>
constexpr bool band_layout_holds() {
  static_assert(sizeof(Colors) == 16, "colours, mask, from, learn");
  static_assert(sizeof(Brush) == 28, "Brush, from, learn");
  return true;
}
template <typename Walk, typename Look, typename Brush>
constexpr bool walk_layout_holds() {
  static_assert(offsetof(Walk, edge) == 0 && offsetof(Walk, faces) == 28, "loaded by one instruction");
  static_assert(offsetof(Walk, furthest) == 20, "stored by one instruction");
  static_assert(offsetof(Walk, pixels) == 24 && offsetof(Walk, other) == 32 && offsetof(Walk, side) == 36);
  static_assert(offsetof(Walk, begin) == 40 && offsetof(Walk, painter) == 44);
  static_assert(offsetof(Walk, now) == 48 && offsetof(Walk, alive_end) == 52);
  static_assert(kOvershoot == 8, "from the side to the width");
  static_assert(kTwoFaces == 1u << 21 && ActiveEdge::kOneLine == 1u << 17 && ActiveEdge::kTall == 1u << 16);
  static_assert(ActiveEdge::kFraction == 20 && sizeof(ActiveEdge) == 16);
  static_assert(static_cast<int>(WalkStop::side) == 0 && static_cast<int>(WalkStop::front) == 1 &&
                static_cast<int>(WalkStop::tall) == 2 && static_cast<int>(WalkStop::look) == 3 &&
                static_cast<int>(WalkStop::end) == 4);
  static_assert(sizeof(Look) == 16 && offsetof(Look, plane) == 0 && offsetof(Look, face) == 12);
  static_assert(offsetof(BrightnessPlane, right) == 4, "a flat look's colour");
  static_assert(Look::kNoMaterial == 0xffff);
  static_assert(BrightnessPlane::kFraction == 26 && offsetof(BrightnessPlane, down) == 8);
  static_assert(sizeof(Brush) == 20, "looks, slots, material, line, colours");
  return true;
}

}  // namespace spanline
