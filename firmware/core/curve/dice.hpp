// Bicubic Bezier patches diced into facets without a crack.
//
// Each patch is a grid of its own, and each side of it is stepped off at the side's own number of steps, which depends
// on the side's four control points alone. A vertex map takes the grid's vertices on a side to the side's own ones. It
// commutes with taking boundaries: inner edges of the grid cancel, and a side is left with each of its own chords once,
// whatever the grid. The neighbour computes the same chords from the same control points, backwards or not, because
// n^3 * B(i/n) is an exact integer and is rounded by a rule that sees only it and n. So no table of who touches whom is
// needed, facets have four corners at most, and no joint leaks.
#pragma once

#include <cstdint>

#include "core/base/slice.hpp"
#include "core/curve/side.hpp"

namespace spanline {

// A patch's control points in clip space; at[i][j], rows i run along v, the points j of a row along u.
struct ClipPatch {
  ClipPoint at[4][4];
};

// Steps a patch off as a grid of vertices, row by row. Its rows and columns have as many steps as the most curved of
// its four rows and of its four columns of control points need; on each side the vertices are the side's own
// (GridSide), which depend on the side's four control points alone.
class PatchDicer {
 public:
  PatchDicer(const ClipPatch& patch, const DiceView& view);

  // Facets along u and along v: at least 1, at most kMaxSteps.
  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }

  // Writes the next of the rows() + 1 rows of vertices: columns() + 1 of them.
  void next_row(Slice<ClipPoint> row);

 private:
  void inner_row(Slice<ClipPoint> row) const;

  ClipPatch patch_;
  std::uint32_t columns_, rows_;
  std::uint32_t own_first_, own_last_;  // steps of the sides along u
  std::uint32_t row_ = 0;
  GridSide left_, right_;  // the sides along v
  SideWalk controls_[4];   // the columns of control points at the grid's steps: an inner row's control points
};

static_assert(sizeof(PatchDicer) <= 1024, "it lives on the stack");

// A facet of a patch: its corners in order, first along u; a triangle where a side has fewer steps than the grid.
struct PatchFacet {
  ClipPoint corners[4];
  std::uint32_t count;  // 3 or 4; a quadrangle need be neither flat nor convex
};

constexpr bool same_point(const ClipPoint& a, const ClipPoint& b) { return a.x == b.x && a.y == b.y && a.w == b.w; }

// The facet of a quadrangle whose neighbouring corners may coincide; `count` below 3 where nothing is left of it.
constexpr PatchFacet facet_of(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c, const ClipPoint& d) {
  PatchFacet facet{};
  const ClipPoint* const corners[4] = {&a, &b, &c, &d};
  for (const ClipPoint* corner : corners) {
    if (facet.count == 0 || !same_point(facet.corners[facet.count - 1], *corner)) {
      facet.corners[facet.count++] = *corner;
    }
  }
  if (facet.count > 1 && same_point(facet.corners[0], facet.corners[facet.count - 1])) --facet.count;
  return facet;
}

// Hands every facet of the patch to `sink(const PatchFacet&)`. `above` and `below` hold a row of vertices each:
// kMaxSteps + 1 are always enough.
template <typename Sink>
void dice(const ClipPatch& patch, const DiceView& view, Slice<ClipPoint> above, Slice<ClipPoint> below, Sink&& sink) {
  PatchDicer dicer(patch, view);
  dicer.next_row(above);
  for (std::uint32_t row = 0; row < dicer.rows(); ++row) {
    dicer.next_row(below);
    for (std::uint32_t i = 0; i < dicer.columns(); ++i) {
      const PatchFacet facet = facet_of(above[i], above[i + 1], below[i + 1], below[i]);
      if (facet.count >= 3) sink(facet);
    }
    const Slice<ClipPoint> passed = above;
    above = below;
    below = passed;
  }
}

}  // namespace spanline
