// What is looked at where it is found out how many chords curves need.
#pragma once

#include <cstdint>

#include "core/geom/camera.hpp"
#include "core/geom/projection.hpp"

namespace spanline {

// What the number of steps depends on, beside the curve's own four control points. All patches that share a boundary
// must be given the same.
struct DiceView {
  std::int32_t near_w;              // Q16.16
  std::int32_t reach;               // Q1.31 guard bands: half the longer side of the screen
  std::uint32_t tolerance;          // 1/16 px that a chord may be off its curve; at least 1
  std::int32_t centre_x, centre_y;  // 28.4 px
  // What a second difference of w is worth that is as great as w, 1/16 px: 3/4 of the focal length, so that a chord may
  // be off in depth by 4/3 of what it may be across. Below 2^16.
  std::uint32_t depth;

  DiceView(const CameraRecord& camera, const Screen& screen, std::uint32_t tolerance_16ths)
      : near_w(camera.near_plane.raw),
        reach((screen.width > screen.height ? screen.width : screen.height) * (1 << 20)),
        tolerance(tolerance_16ths),
        centre_x(screen.width * (kSubpixels / 2)),
        centre_y(screen.height * (kSubpixels / 2)),
        depth(static_cast<std::uint32_t>(camera.focal.raw) * 3 >> 10) {}
};
static_assert(kMaxFocalPx <= 1 << 12 && kSubpixels == 16, "3/4 of the focal length in 28.4");
static_assert(kGuardPx == 1 << 10 && kMaxExtent < (1 << 11) - 1, "reach, and a little more, is below one");

inline constexpr int kProjectedBits = 14;  // of a place in 28.4 px, in guard bands
static_assert(kGuardPx * kSubpixels == 1 << kProjectedBits);

// Where a point is on the screen, 28.4 px; kNotProjected before the near plane.
ScreenXY place_on_screen(const ClipPoint& p, const DiceView& view);
inline constexpr ScreenXY kNotProjected{INT16_MIN, 0};

}  // namespace spanline
