// The second surface mode: patches stepped off as points into a band of lines with a depth buffer.
//
// A pixel of the band is one word, depth above colour, and the larger one stays: what is seen does not depend on the
// order of drawing, nor on how the picture is cut into bands.
#pragma once

#include "core/base/slice.hpp"
#include "core/curve/point_rows.hpp"
#include "core/frame/piece_shade.hpp"
#include "core/vsg/blocks.hpp"

namespace spanline {

// The band's pixels, erased; as many lines as there is room for.
struct PointStorage {
  Slice<std::uint32_t> cells;
  Slice<std::uint16_t> faces;  // as many, or none: whose points are seen
};

class PointSource {
 public:
  PointSource() = default;
  PointSource(const PointStorage& storage, const Screen& screen) : p_(storage), screen_(screen) {}

  // Lines that there is room for.
  std::uint32_t lines() const { return p_.cells.size() / screen_.width; }

  // Clears the lines [top, bottom), no more than lines(); the points to come are for them.
  void begin_band(std::int32_t top, std::int32_t bottom);

  // How far off about the reader's current face is, a patch; Q16.16.
  static std::int32_t distance(const FacetReader& reader);

  // Plots the reader's current face, a patch.
  void plot(const FacetReader& reader, std::uint16_t face, const PatchLook& look);

  // The points of a line of the band that lie in front of what has `depth` there (Q16.13; where `any` is not set,
  // nothing has), among the columns [left, right): hands `points(column, payload, face, depth)` every one, its depth
  // Q16 and its face 0 where faces are not kept, and `rest(left, right)` the runs between, all from left to right.
  template <typename Points, typename Rest>
  void show(std::uint32_t line, std::uint32_t left, std::uint32_t right, bool any, const DepthRamp& depth,
            const Points& points, const Rest& rest) const;

  // Points stepped to since clear_statistics(), over all bands.
  std::uint32_t points() const { return points_; }
  void clear_statistics() { points_ = 0; }

 private:
  struct Job;
  struct Row;
  struct Reach;

  bool hidden(const Job& job, const Reach& reach, std::int32_t nearest) const;
  bool hidden(const Job& job, const PointRows& row, std::int32_t nearest) const;
  void plot(const Job& job, const ScreenPiece& piece);
  [[gnu::noinline]]  // keeps its rows off the stack while normals are worked out
  void
  plot_rows(const Job& job, const ScreenPiece& piece, std::int32_t nearest, PieceShade& shade);
  void put(const Job& job, const Row& row, const PointPixel* points, std::uint32_t column, std::uint32_t count);

  PointStorage p_;
  Screen screen_;
  std::int32_t top_ = 0, bottom_ = 0;
  std::uint32_t points_ = 0;
};

template <typename Points, typename Rest>
void PointSource::show(std::uint32_t line, std::uint32_t left, std::uint32_t right, bool any, const DepthRamp& depth,
                       const Points& points, const Rest& rest) const {
  const std::uint32_t first = (line - static_cast<std::uint32_t>(top_)) * screen_.width;
  std::uint32_t from = left;
  for (std::uint32_t x = left; x < right; ++x) {
    const std::uint32_t cell = p_.cells[first + x];
    if (cell == 0) continue;
    const auto nearest = static_cast<std::int32_t>(cell >> 16);
    // Rounding may carry a ramp's ends a little out of Q16.13.
    if (any && static_cast<std::int32_t>(depth.at(static_cast<std::int32_t>(x))) >> 13 >= nearest) continue;
    if (from != x) rest(from, x);
    points(x, static_cast<std::uint16_t>(cell), p_.faces.empty() ? std::uint16_t{0} : p_.faces[first + x], cell >> 16);
    from = x + 1;
  }
  if (from != right) rest(from, right);
}

}  // namespace spanline
