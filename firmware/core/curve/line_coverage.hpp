// How much of each pixel of one scan line a curve covers: a mask of 4 x 4 samples a pixel (Carpenter's A-buffer, 1984),
// so that parts of a curve that overlap count once.
#pragma once

#include <bit>
#include <cstdint>

#include "core/base/pool.hpp"

namespace spanline {

using CoverageMask = std::uint16_t;  // bit 4 * row + column, from the top left sample

class LineCoverage {
 public:
  LineCoverage() = default;
  // One mask a column, from 0 on; at least `width`.
  LineCoverage(PoolRef<CoverageMask> masks, std::int32_t width) : masks_(masks), width_(width), left_(width) {
    for (std::int32_t x = 0; x < width; ++x) mask(x) = 0;
  }

  // Covers a whole pixel; columns off the screen are ignored.
  void pixel(std::int32_t x) { pixels(x, x + 1); }
  void pixels(std::int32_t left, std::int32_t right) {
    if (!touch(left, right)) return;
    for (std::int32_t x = left; x < right; ++x) mask(x) = 0xffff;
  }

  // Covers samples [left, right) of a row 0 … 3, counted in quarters of a pixel.
  void samples(std::int32_t left, std::int32_t right, unsigned row) {
    std::int32_t from = left >> 2, to = (right + 3) >> 2;
    if (!touch(from, to)) return;
    for (std::int32_t x = from; x < to; ++x) {
      unsigned bits = 15;
      if (4 * x < left) bits &= 15u << (left - 4 * x);
      if (4 * x + 4 > right) bits &= 15u >> (4 * x + 4 - right);
      mask(x) = static_cast<CoverageMask>(mask(x) | (bits & 15u) << (4 * row));
    }
  }

  // Hands every covered pixel to sink(x, sixteenths) and forgets it.
  template <typename Sink>
  void take(Sink&& sink) {
    for (std::int32_t x = left_; x < right_; ++x) {
      if (mask(x) == 0) continue;
      sink(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(std::popcount(mask(x))));
      mask(x) = 0;
    }
    left_ = width_;
    right_ = 0;
  }

 private:
  CoverageMask& mask(std::int32_t x) const { return masks_[static_cast<std::size_t>(x)]; }

  // Cuts a run of columns off at the screen's ends and notes it; false where nothing is left.
  bool touch(std::int32_t& left, std::int32_t& right) {
    if (left < 0) left = 0;
    if (right > width_) right = width_;
    if (left >= right) return false;
    if (left < left_) left_ = left;
    if (right > right_) right_ = right;
    return true;
  }

  PoolRef<CoverageMask> masks_;
  std::int32_t width_ = 0, left_ = 0, right_ = 0;  // columns [left, right) may be covered
};

}  // namespace spanline
