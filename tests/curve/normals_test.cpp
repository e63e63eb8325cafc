#include "core/curve/normals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "curve/patch_scene.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

struct Vector {
  double x, y, z;
};
Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(Vector a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }
double degrees_between(Vector a, Vector b) {
  return std::atan2(length(cross(a, b)), a.x * b.x + a.y * b.y + a.z * b.z) * 180 / M_PI;
}
Vector vector_of(Normal10 n) {
  return {static_cast<double>(n.x()), static_cast<double>(n.y()), static_cast<double>(n.z())};
}

void weights(double t, double (&value)[4], double (&slope)[4]) {
  const double s = 1 - t;
  const double v[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  const double d[4] = {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
  std::copy(v, v + 4, value);
  std::copy(d, d + 4, slope);
}

// The exact normal, not of unit length.
Vector normal_at(const PatchShape& patch, double u, double v) {
  double bu[4], du[4], bv[4], dv[4];
  weights(u, bu, du);
  weights(v, bv, dv);
  Vector along{}, across{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Position& p = patch.at[i][j];
      along = {along.x + bv[i] * du[j] * p.x, along.y + bv[i] * du[j] * p.y, along.z + bv[i] * du[j] * p.z};
      across = {across.x + dv[i] * bu[j] * p.x, across.y + dv[i] * bu[j] * p.y, across.z + dv[i] * bu[j] * p.z};
    }
  }
  return cross(along, across);
}

PatchShape shape_of(const PatchPoints& points) {
  PatchShape shape;
  for (std::size_t i = 0; i < 16; ++i) shape.at[i / 4][i % 4] = points[i / 4][i % 4];
  return shape;
}

// The largest error over a grid, degrees; on the rims the exact normal a hair inside is the measure.
double worst_error(const PatchShape& shape, const NormalGrid& grid) {
  double worst = 0;
  for (std::uint32_t row = 0; row <= grid.rows; ++row) {
    const NormalRow normals(PatchTangents(shape, grid), row);
    for (std::uint32_t column = 0; column <= grid.columns; ++column) {
      constexpr double kHair = 1e-6;
      const double u = std::clamp(static_cast<double>(column) / grid.columns, kHair, 1 - kHair);
      const double v = std::clamp(static_cast<double>(row) / grid.rows, kHair, 1 - kHair);
      worst = std::max(worst, degrees_between(vector_of(normals.at(column)), normal_at(shape, u, v)));
    }
  }
  return worst;
}

TEST(NormalRow, IsWithinHalfADegreeOnTheTeapotPolesIncluded) {
  for (const PatchPoints& points : teapot_patches()) {
    for (const NormalGrid grid : {NormalGrid{1, 1}, {7, 12}, {16, 16}, {34, 9}}) {
      EXPECT_LT(worst_error(shape_of(points), grid), 0.5) << grid.rows << " x " << grid.columns;
    }
    EXPECT_LT(worst_error(shape_of(points), {128, 128}), 2);
  }
}

TEST(NormalRow, TurnsRoundWithTheGrid) {
  const PatchShape shape = shape_of(random_patches(1, 1)[0]);
  PatchShape turned;
  for (int i = 0; i < 16; ++i) turned.at[i / 4][i % 4] = shape.at[i % 4][3 - i / 4];
  for (std::uint32_t i = 0; i <= 8; ++i) {
    const Vector n = vector_of(NormalRow(PatchTangents(shape, {8, 8}), i).at(3)),
                 m = vector_of(NormalRow(PatchTangents(turned, {8, 8}), 5).at(i));
    EXPECT_LT(degrees_between(n, m), 0.5);
  }
}

TEST(NormalRow, IsDefinedWhereThereIsNone) {
  PatchShape point{};
  EXPECT_EQ(NormalRow(PatchTangents(point, {4, 4}), 3).at(2).packed, Normal10::pack(0, 0, 511).packed);
  for (int i = 0; i < 16; ++i) point.at[i / 4][i % 4] = {static_cast<std::int16_t>(i * 100), 0, 0};  // a line
  EXPECT_EQ(NormalRow(PatchTangents(point, {4, 4}), 0).at(4).packed, Normal10::pack(0, 0, 511).packed);
}

// The exact normal of a facet, from its corners in clip space: where the matrix takes it from.
Vector exact_normal(const ClipMatrix& matrix, bool mirrored, const std::array<ClipPoint, 4>& p) {
  const auto between = [](const ClipPoint& from, const ClipPoint& to) {
    return Vector{static_cast<double>(to.x) - from.x, static_cast<double>(to.y) - from.y,
                  static_cast<double>(to.w) - from.w};
  };
  const Vector n = cross(between(p[0], p[2]), between(p[1], p[3]));
  const auto back = [&](int i) {
    const double sum = matrix.linear[0][i] * n.x + matrix.linear[1][i] * n.y + matrix.linear[2][i] * n.z;
    return mirrored ? -sum : sum;
  };
  return {back(0), back(1), back(2)};
}

// Hands the corners of all cells of the patch's grid to cell(corners, u, v of the middle).
template <typename Cell>
void for_cells(const ClipPatch& patch, const DiceView& view, Cell&& cell) {
  std::vector<ClipPoint> above(kMaxSteps + 1), below(kMaxSteps + 1);
  PatchDicer dicer(patch, view);
  GridRow row;
  for (std::uint32_t i = 0; i <= dicer.rows(); ++i, above.swap(below)) {
    dicer.next_row(row);
    dicer.step_off(row, below.data());
    for (std::uint32_t j = 0; j <= dicer.columns(); ++j) EXPECT_TRUE(same_point(below[j], dicer.vertex(row, j)));
    for (std::uint32_t j = 0; i > 0 && j < dicer.columns(); ++j) {
      cell(std::array<ClipPoint, 4>{above[j], above[j + 1], below[j + 1], below[j]}, (j + 0.5) / dicer.columns(),
           (i - 0.5) / dicer.rows());
    }
  }
}

TEST(FacetNormals, AreThoseOfTheDiagonalsAndNearThePatchesOwn) {
  double off = 0, count = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    PatchView view = random_view(seed, seed % 2 == 0 ? 1 : 4, 8);
    const bool mirrored = seed % 3 == 0;
    if (mirrored) {
      for (auto& row : view.matrix.linear) row[0] = -row[0];
    }
    const FacetNormals normals(view.matrix, mirrored);
    for (const PatchPoints& points : teapot_patches()) {
      for_cells(view.patch(points), view.dice, [&](const std::array<ClipPoint, 4>& p, double u, double v) {
        const Vector exact = exact_normal(view.matrix, mirrored, p),
                     got = vector_of(normals.of(p[0], p[1], p[2], p[3]));
        if (length(exact) == 0) return;
        EXPECT_LT(degrees_between(exact, got), 0.5);
        off += degrees_between(normal_at(shape_of(points), u, v), got);
        ++count;
      });
    }
  }
  EXPECT_LT(off / count, 1.5);  // the mean; where the patch turns sharply a cell may be off by tens of degrees
}

TEST(FacetNormals, AreDefinedWhereThereAreNone) {
  const ClipPoint p{100, 200, 300}, q{400, 200, 300};
  const FacetNormals normals(random_view(1, 1, 8).matrix, false);
  EXPECT_EQ(normals.of(p, p, p, p).packed, Normal10::pack(0, 0, 511).packed);
  EXPECT_EQ(normals.of(p, q, p, q).packed, Normal10::pack(0, 0, 511).packed);
  // From end to end of clip space.
  const std::int32_t far = INT32_MAX;
  const ClipPoint a{-far, -far, far}, b{-far, far, far}, c{far, far, far}, d{far, -far, far};
  EXPECT_NE(normals.of(a, b, c, d).packed, Normal10::pack(0, 0, 511).packed);
}

}  // namespace
}  // namespace spanline::test
