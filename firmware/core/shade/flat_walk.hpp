// The walk of a line of RGB565 whose faces have one colour each: walk_on() with fill_span().
#pragma once

#include "core/shade/fill_words.hpp"

namespace spanline {

// LineWalk::faces are words, the faces' colours. For any core.
inline WalkStop flat_walk_plain(LineWalk& walk, FaceId shown) {
  const auto paint = [pixels = walk.pixels, words = static_cast<const std::uint16_t*>(walk.faces)](
                         std::int32_t left, std::int32_t right, FaceId face) {
    fill_span(pixels, left, right, words[face]);
    return true;
  };
  return walk_on(walk, shown, paint);
}

#if defined(__ARM_ARCH_ISA_THUMB)
// The same in assembly.
WalkStop flat_walk(LineWalk& walk, FaceId shown) asm("spanline_flat_walk");
#else
inline WalkStop flat_walk(LineWalk& walk, FaceId shown) { return flat_walk_plain(walk, shown); }
#endif

// The same from the beginning of a line.
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
WalkStop flat_line(LineWalk& walk) asm("spanline_flat_line");
#else
inline WalkStop flat_line(LineWalk& walk) {
  walk.begin_line();
  return flat_walk(walk, 0);
}
#endif

}  // namespace spanline
