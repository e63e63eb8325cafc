// The walk of a line of RGB565 whose faces may be smooth: walk_on() with fill_span() and smooth_span().
#pragma once

#include "core/shade/fill_words.hpp"
#include "core/shade/smooth_brush.hpp"

namespace spanline {

// LineWalk::painter is a brush of this type, LineWalk::faces is not used. Stops at looks that the brush does not know.
template <typename Brush>
WalkStop smooth_walk_by(LineWalk& walk, FaceId shown) {
  const auto paint = [pixels = walk.pixels, brush = *static_cast<const Brush*>(walk.painter)](
                         std::int32_t left, std::int32_t right, FaceId face) {
    const FaceLook& look = brush.look(face);
    if (!brush.knows(face, look)) [[unlikely]] {
      if (!look.flat_of(face)) return false;
      fill_span(pixels, left, right, look.color());
      return true;
    }
    smooth_span(pixels, left, right, look.plane, brush.line(), brush.colors());
    return true;
  };
  return walk_on(walk, shown, paint);
}
// Likewise of one that learns them.
template <typename Brush>
WalkStop learning_walk_by(LineWalk& walk, FaceId shown) {
  const auto paint = [pixels = walk.pixels, &brush = *static_cast<const Brush*>(walk.painter)](
                         std::int32_t left, std::int32_t right, FaceId face) {
    const FaceLook& look = brush.learned(face);
    if (look.smooth()) {
      smooth_span(pixels, left, right, look.plane, brush.line(), brush.colors());
    } else {
      fill_span(pixels, left, right, look.color());
    }
    return true;
  };
  return walk_on(walk, shown, paint);
}
// For any core.
inline WalkStop smooth_walk_plain(LineWalk& walk, FaceId shown) { return learning_walk_by<SmoothBrush>(walk, shown); }

#if defined(__ARM_ARCH_ISA_THUMB)
// The same in assembly.
WalkStop smooth_walk(LineWalk& walk, FaceId shown) asm("spanline_smooth_walk");
#else
inline WalkStop smooth_walk(LineWalk& walk, FaceId shown) { return smooth_walk_plain(walk, shown); }
#endif

// The same from the beginning of a line.
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
WalkStop smooth_line(LineWalk& walk) asm("spanline_smooth_line");
#else
inline WalkStop smooth_line(LineWalk& walk) {
  walk.begin_line();
  return smooth_walk(walk, 0);
}
#endif

}  // namespace spanline
