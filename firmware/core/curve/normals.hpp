// Normals of a bicubic patch, from its control points alone: in mesh units, so that they do not depend on the view.
//
// The tangents are the patch's own derivatives, as 6 b1 - 3 b2 + 2 b3 of a walk along it gives them; the raw first
// difference b1 would err by half a step's turn. Only directions matter, so every stage keeps about 14 bits of a common
// exponent and all is done in 32 bits. The result is within half a degree of the exact normal (tests).
#pragma once

#include <cstdint>

#include "core/curve/short_vector.hpp"
#include "core/geom/clip_matrix.hpp"

namespace spanline {

// The control points of a patch, mesh units; at[i][j], rows i run along v, the points j of a row along u.
struct PatchShape {
  Position at[4][4];
};

// Where a normal is wanted: at v = row / rows, u = column / columns.
struct NormalGrid {
  static constexpr std::uint32_t kMostSteps = 128;
  std::uint32_t rows, columns;  // 1 … kMostSteps
};

// The tangents' control points of a patch.
class PatchTangents {
 public:
  PatchTangents(const PatchShape& patch, const NormalGrid& grid);

 private:
  friend class NormalRow;
  struct Short {  // 14 bits a component
    std::int16_t v[3];
  };
  NormalGrid grid_;
  Short along_[12], across_[12];  // differences of neighbours in a row, and in a column
};

// The tangents' control points along one row of a grid.
class NormalRow {
 public:
  // row <= rows of the grid that the tangents were made for.
  NormalRow(const PatchTangents& patch, std::uint32_t row);

  // The normal at column <= columns: on the side that sees u, v turn counter-clockwise. Where one
  // tangent vanishes on the patch's rim, as at a pole, it is what the normals beside it tend to. (0, 0, 511) where the
  // patch has no normal even so.
  Normal10 at(std::uint32_t column) const;

 private:
  std::uint32_t row_;
  NormalGrid grid_;
  ShortVector along_[3];   // control points of the derivative along u, a quadratic
  ShortVector across_[4];  // of the derivative along v, a cubic in u
};

// Normals of the facets that a patch is diced into, from their corners in clip space: turned by a linear map, a product
// of vectors is so by the map's cofactors, and turned back by its transpose.
class FacetNormals {
 public:
  FacetNormals() = default;
  // Of meshes that `matrix` takes to clip space; `mirrored`: by a transform that is (is_mirrored).
  FacetNormals(const ClipMatrix& matrix, bool mirrored);

  // Of the facet with these corners, in order, what both its diagonals stand upright on: on the side that sees them
  // turn counter-clockwise in the mesh. (0, 0, 511) where they span nothing.
  Normal10 of(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c, const ClipPoint& d) const;

  // A row of the matrix, 15 bits a component, with the sign that makes what corners span show its front.
  ShortVector row(int i) const {
    const auto in = [&](int column) {
      return i == 0 ? low_half(xy_[column]) : i == 1 ? high_half(xy_[column]) : w_[column];
    };
    return {{in(0), in(1), in(2)}};
  }

 private:
  // Columns of the matrix, 15 bits a component: x and y in one word, and w.
  std::uint32_t xy_[3];
  std::int32_t w_[3];
};

}  // namespace spanline
