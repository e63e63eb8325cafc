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

// How a side of a patch is stepped off.
struct PatchSide {
  std::uint32_t own = 0;  // steps
  CurveScale scale;       // at these
};

// A row of a patch's grid before it is stepped off.
struct GridRow {
  ClipPoint control[4];
  ClipPoint left, right;  // its first and last vertex
  PatchSide own;          // of the patch's own first or last row, where this is one; no steps: an inner row
};

// Steps a patch off as a grid of vertices, row by row. Its rows and columns have as many steps as the most curved of
// those along its sides and a quarter of the way between them need, which are near enough to all others; on each side
// the vertices are the side's own (GridSide), which depend on the side's four control points alone.
class PatchDicer {
 public:
  // `patch` must outlive the dicer.
  PatchDicer(const ClipPatch& patch, const DiceView& view);
  // Where the control points were projected already, or are kNotProjected: so it is for all patches that meet, or for
  // none.
  PatchDicer(const ClipPatch& patch, const ScreenXY (&projected)[4][4], const DiceView& view);

  // Facets along u and along v: at least 1, at most kMaxSteps.
  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  // Whether all coordinates are below 2^29, so that differences fit; so they are but where a patch reaches far away.
  bool near() const { return inner_.along.is_short; }

  // The next of the rows() + 1 rows. All its vertices lie in the hull of its control points, left and right.
  void next_row(GridRow& row);

  // Puts the row's columns() + 1 vertices in order to `out`.
  void step_off(const GridRow& row, ClipPoint* out) const;

  // The vertex that step_off() puts to out[column].
  ClipPoint vertex(const GridRow& row, std::uint32_t column) const;

  // Hands them to `vertex(const ClipPoint&)`, one by one.
  template <typename Vertex>
  void step_off(const GridRow& row, Vertex&& vertex) const {
    if (row.own.own != 0) {
      with_walk(row.control, row.own.own, row.own.scale, [&](auto& walk) { step_side_off(walk, columns_, vertex); });
      return;
    }
    vertex(row.left);
    with_walk(row.control, columns_, inner_.along, [&](auto& walk) {
      for (std::uint32_t i = 1; i < columns_; ++i) {
        walk.step();
        vertex(walk.between());
      }
    });
    vertex(row.right);
  }

 private:
  // Whether the points of a side along v are those of the column of control points.
  bool is_column(const PatchSide& side) const { return side.own == rows_ && side.scale == inner_.across; }
  ClipPoint end_of_row(const PatchSide& side, int j, PointWalk<std::int32_t>& walk) const;
  void find_steps(const ScreenXY (&places)[4][4], const DiceView& view);

  const ClipPatch* patch_;
  std::uint32_t columns_, rows_;
  PatchSide first_, last_;  // sides along u
  PatchSide left_, right_;  // sides along v
  struct Inner {
    CurveScale along, across;
  } inner_;  // of rows and columns that are no sides
  std::uint32_t row_ = 0;
  // The row's control points and ends between the first and the last row, where 32 bits are enough for them; each is
  // made where it is used, and not before.
  union {
    PointWalk<std::int32_t> control_[4];
  };
  union {
    PointWalk<std::int32_t> end_[2];
  };
};

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
  const auto fill = [&](Slice<ClipPoint> row) {
    CHECK(row.size() > dicer.columns());
    GridRow grid;
    dicer.next_row(grid);
    dicer.step_off(grid, row.data());
  };
  fill(above);
  for (std::uint32_t row = 0; row < dicer.rows(); ++row) {
    fill(below);
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
