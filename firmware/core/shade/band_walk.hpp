// The walks of lines of RGB565 where looks are kept of faces that were met lately, and of others not even the number of
// their look: flat_walk() and smooth_walk() for them. They stop at no look, but learn it.
#pragma once

#include "core/shade/face_colors.hpp"
#include "core/shade/smooth_walk.hpp"

namespace spanline {

// LineWalk::painter is a FaceColors. For any core.
inline WalkStop band_flat_walk_plain(LineWalk& walk, FaceId shown) {
  const auto paint = [pixels = walk.pixels, colors = *static_cast<const FaceColors*>(walk.painter)](
                         std::int32_t left, std::int32_t right, FaceId face) {
    fill_span(pixels, left, right, colors[face]);
    return true;
  };
  return walk_on(walk, shown, paint);
}
// LineWalk::painter is a BandBrush.
inline WalkStop band_smooth_walk_plain(LineWalk& walk, FaceId shown) {
  return learning_walk_by<BandBrush>(walk, shown);
}

#if defined(__ARM_ARCH_ISA_THUMB)
// The same in assembly.
WalkStop band_flat_walk(LineWalk& walk, FaceId shown) asm("spanline_band_flat_walk");
WalkStop band_smooth_walk(LineWalk& walk, FaceId shown) asm("spanline_band_smooth_walk");
#else
inline WalkStop band_flat_walk(LineWalk& walk, FaceId shown) { return band_flat_walk_plain(walk, shown); }
inline WalkStop band_smooth_walk(LineWalk& walk, FaceId shown) { return band_smooth_walk_plain(walk, shown); }
#endif

}  // namespace spanline
