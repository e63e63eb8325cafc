// How many chords a curve needs to stay within a tolerance on the screen.
//
// In steps of 1 / n a chord leaves its curve by at most max |f''| / (8 n n), and f'' is 6 times a second difference d
// of the control points. On the screen that is d.xy - p * d.w over w, p the place there: what is farther ahead bends
// less, and what of a second difference runs along the line of sight is not seen.
#pragma once

#include <cstdint>

#include "core/curve/reach.hpp"

namespace spanline {

// What the number of steps depends on, beside the curve's own four control points. All patches that share a boundary
// must be given the same.
struct DiceView {
  std::int32_t near_w;              // Q16.16
  std::int32_t reach;               // Q1.31 guard bands: half the longer side of the screen
  std::uint32_t tolerance;          // 1/16 px that a chord may be off its curve; at least 1
  std::int32_t centre_x, centre_y;  // 28.4 px

  DiceView(const Projection& projection, const Screen& screen, std::uint32_t tolerance_16ths)
      : near_w(projection.near_w),
        reach((screen.width > screen.height ? screen.width : screen.height) * (1 << 20)),
        tolerance(tolerance_16ths),
        centre_x(projection.centre_x),
        centre_y(projection.centre_y) {}
};
static_assert(kGuardPx == 1 << 10 && kMaxExtent < (1 << 11) - 1, "reach, and a little more, is below one");

// Where a point is on the screen, 28.4 px; kNotProjected before the near plane.
ScreenXY place_on_screen(const ClipPoint& p, const DiceView& view);
inline constexpr ScreenXY kNotProjected{INT16_MIN, 0};

// What the places of control points lie between, as far as they are seen: Q1.31 guard bands off the screen's centre.
struct PlaceBounds {
  struct Range {
    std::int32_t middle;  // its negative
    std::int32_t half;    // of what it spans
  } x, y;

  PlaceBounds(const PackedBox& places, const DiceView& view);
};

// How far a curve bends on the screen, as bend / nearest: what the number of its steps follows from.
struct Bend {
  std::uint32_t bend = 0;     // below 2^31
  std::uint32_t nearest = 1;  // from 1 to 2^31

  void widen(const Bend& other) {
    if (std::uint64_t{bend} * other.nearest < std::uint64_t{other.bend} * nearest) *this = other;
  }
  // 1 … kMaxSteps.
  std::uint32_t steps(const DiceView& view) const;
};

// What a curve's Bend is made of. All of it is linear in the control points, so that it can be had for curves between
// others.
class CurveBend {
 public:
  // The curve of every `stride`th point, which `bounds` hold, without the last `down` bits: so many that 27 are left.
  CurveBend(const ClipPoint* p, int stride, const PlaceBounds& bounds, int down, const DiceView& view);
  // To the curve whose control points are halfway to those of another one, made with the same bounds.
  void go_halfway(const CurveBend& other);

  // With the bounds that it was made with.
  Bend bend(const PlaceBounds& bounds) const;

 private:
  // Of both second differences d - p * d.w, where p is in the middle of its bounds, and 2 * d.w.
  struct Off {
    std::int32_t x, y, w;  // below 2^30
  } off_[2];
  std::int32_t nearest_;  // w
};

// How many equal steps in t bring the curve's chords on the screen within the tolerance: 1 … kMaxSteps. The same for
// the curve run backwards.
std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view);

}  // namespace spanline
