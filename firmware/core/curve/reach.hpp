// Where curves lie in clip space, and how many bits their points need.
#pragma once

#include <bit>
#include <cstdint>

#include "core/curve/scaled.hpp"
#include "core/geom/projection.hpp"

namespace spanline {

// How a curve's points are had: in 32 bits, from control points without their last `down` bits, or in 64 from all bits.
struct CurveScale {
  bool is_short = false;
  int down = 0;

  friend bool operator==(const CurveScale&, const CurveScale&) = default;
};

// What that depends on: where the control points of a curve lie.
class CurveReach {
 public:
  CurveReach() = default;
  // Of the curve of every `stride`th point.
  explicit CurveReach(const ClipPoint* p, int stride = 1) {
    for (int i = 0; i < 4; ++i, p += stride) widen(*p);
  }
  void widen(const ClipPoint& p) {
    any_ |= magnitude_bits(p.x) | magnitude_bits(p.y) | magnitude_bits(p.w);
    if (p.w < nearest_) nearest_ = p.w;
  }
  // Of both curves.
  void widen(const CurveReach& other) {
    any_ |= other.any_;
    if (other.nearest_ < nearest_) nearest_ = other.nearest_;
  }

  // What is more than 27 bits of the coordinates.
  int beyond_27_bits() const { return any_ >> 27 == 0 ? 0 : static_cast<int>(std::bit_width(any_)) - 27; }

  // For steps of 1 / steps. Points that are off by the bits given up and half as much more are so by less than a
  // sixteenth of a pixel on the screen.
  CurveScale scale(std::uint32_t steps) const {
    constexpr int kFinest = 16;
    static_assert(3 * kGuardPx * kSubpixels <= 1 << kFinest, "x or y, and w are off");
    const int bits = static_cast<int>(std::bit_width(any_)), down = bits + kCubes[steps].shift - 29;
    if (bits > 29 || nearest_ < 1 << kFinest || (down > 0 && (nearest_ >> kFinest) >> down == 0)) return {};
    return {true, down > 0 ? down : 0};
  }

 private:
  static std::uint32_t magnitude_bits(std::int32_t v) { return static_cast<std::uint32_t>(v ^ (v >> 31)); }

  std::uint32_t any_ = 0;  // all bits of the coordinates' magnitudes
  std::int32_t nearest_ = INT32_MAX;
};

}  // namespace spanline
