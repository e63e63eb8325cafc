// Stepping a piece off, point by point along its rows (seed 3; Lien, Shantz and Pratt 1987), and the pixels between.
#pragma once

#include <cstdint>

#include "core/curve/basis.hpp"
#include "core/curve/point_piece.hpp"

namespace spanline {

// The differences of a cubic at steps of 1 / n, n at most kMostPieceSteps, for control points no farther apart than
// such a piece's. Each is rounded to the nearest a few times, so that after n steps a point is at most
// 0.6 * n(n-1)(n-2)/6 + … units off: a 200th of a pixel for 24 steps.
CurveBasis<std::int32_t> piece_basis(const std::int32_t (&p)[4], std::uint32_t n);

// A point as its pixel, with its depth.
struct PointPixel {
  std::int16_t x, y;   // px
  std::int32_t depth;  // Q16.10
};

// The rows of a piece from the first to the last.
class PointRows {
 public:
  explicit PointRows(const ScreenPiece& piece);

  // Control points of the current row.
  std::int32_t control(PointAxis axis, int j) const { return columns_[axis][j].b0.value(); }
  // Whether a point of the row may lie in the window.
  bool meets(const PointWindow& window) const;
  // Writes the row's columns + 1 points.
  void step_off(PointPixel* out) const;
  // Writes for each of them by which side the patch turns there, along the row against along the columns: positive as x
  // against y.
  void turns(std::int32_t* out) const;
  void step();

 private:
  CurveBasis<std::int32_t> columns_[kPointAxes][4];
  std::uint32_t count_;
};

// Hands `fill(column, pixel)` the pixels that lie within the diamond of four points, two of either row, and are none
// of them. Neighbours touch, so that opposite corners are at most two apart: where they have the same x or y and differ
// by an even number in the other, they are none or two apart.
template <typename Fill>
void fill_diamonds(const PointPixel* above, const PointPixel* below, std::uint32_t columns, Fill&& fill) {
  for (std::uint32_t i = 0; i < columns; ++i) {
    const PointPixel &a = above[i], &b = above[i + 1], &c = below[i + 1], &d = below[i];
    const int across_x = a.x ^ c.x, across_y = a.y ^ c.y, along_x = b.x ^ d.x, along_y = b.y ^ d.y;
    if (((across_x | across_y | along_x | along_y) & 1) != 0) continue;
    const bool lying = across_x != 0 && across_y == 0 && along_x == 0 && along_y != 0;
    const bool standing = across_x == 0 && across_y != 0 && along_x != 0 && along_y == 0;
    if (!lying && !standing) continue;
    fill(i, PointPixel{static_cast<std::int16_t>((a.x + c.x) / 2), static_cast<std::int16_t>((a.y + c.y) / 2),
                       (a.depth >> 1) + (c.depth >> 1)});
  }
}

}  // namespace spanline
