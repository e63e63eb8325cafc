// The teapot, diced and stepped off as points, against a fine tessellation in floating point, patch by patch: no hole,
// and the outline within a pixel. That neighbours leave no gap between them is dice_test's: there every joint is
// compared exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/point_rows.hpp"
#include "curve/coverage.hpp"
#include "curve/patch_scene.hpp"

namespace spanline::test {
namespace {

constexpr int kFine = 48;  // steps of the fine tessellation, each way

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Place place_of(double x, double y, double w, const Screen& screen) {
  return {screen.width / 2.0 + kGuardPx * x / w, screen.height / 2.0 + kGuardPx * y / w};
}

void add_fine(const ClipPatch& patch, const Screen& screen, Coverage& out) {
  std::vector<Place> above, below;
  for (int j = 0; j <= kFine; ++j) {
    const auto v = bernstein(static_cast<double>(j) / kFine);
    below.clear();
    for (int i = 0; i <= kFine; ++i) {
      const auto u = bernstein(static_cast<double>(i) / kFine);
      double x = 0, y = 0, w = 0;
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t c = 0; c < 4; ++c) {
          const ClipPoint& p = patch.at[r][c];
          x += v[r] * u[c] * p.x;
          y += v[r] * u[c] * p.y;
          w += v[r] * u[c] * p.w;
        }
      }
      below.push_back(place_of(x, y, w, screen));
    }
    for (std::size_t i = 0; j > 0 && i < kFine; ++i) out.add({above[i], above[i + 1], below[i + 1], below[i]});
    above.swap(below);
  }
}

// By the engine's own projection, to 1/16 px.
void add_diced(const ClipPatch& patch, const PatchView& view, Coverage& out) {
  ClipPoint rows[2][kMaxSteps + 1];
  std::vector<Place> polygon;
  dice(patch, view.dice, rows[0], rows[1], [&](const PatchFacet& facet) {
    polygon.clear();
    for (std::uint32_t i = 0; i < facet.count; ++i) {
      const ScreenXY at = view.projection(facet.corners[i]).at;
      polygon.push_back({at.x / 16.0, at.y / 16.0});
    }
    out.add(polygon);
  });
}

// The pixels of points, and what is filled between them.
void add_points(const ClipPatch& patch, const PatchView& view, const Screen& screen, Coverage& out) {
  PieceCutter cutter(patch, view.projection, {0, screen.height, screen.width}, false);
  for (ScreenPiece piece; cutter.next(piece);) {
    PointPixel points[2][kMostPieceSteps + 1];
    PointRows rows(piece);
    for (std::uint32_t i = 0; i <= piece.rows; ++i, rows.step()) {
      const PointPixel* const above = points[(i + 1) % 2];
      PointPixel* const below = points[i % 2];
      rows.step_off(below);
      for (std::uint32_t j = 0; j <= piece.columns; ++j) out.add(below[j].x, below[j].y);
      if (i == 0) continue;
      fill_diamonds(above, below, piece.columns, [&](std::uint32_t, const PointPixel& p) { out.add(p.x, p.y); });
    }
  }
}

bool inside_all_planes(const ClipPatch& patch, const Projection& projection) {
  for (const auto& row : patch.at) {
    for (const ClipPoint& p : row) {
      if (projection.outcode(p) != 0) return false;
    }
  }
  return true;
}

// Half a pixel of tolerance. False where a part of the model is outside the view.
bool compare(const Screen& screen, double distance, std::uint64_t seed) {
  static const auto patches = teapot_patches();
  const PatchView view = random_view(seed, distance, 8, screen);
  const auto outside = [&](const PatchPoints& points) {
    return !inside_all_planes(view.patch(points), view.projection);
  };
  if (std::any_of(patches.begin(), patches.end(), outside)) return false;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const ClipPatch patch = view.patch(patches[i]);
    Coverage fine(screen.width, screen.height), diced(screen.width, screen.height);
    add_fine(patch, screen, fine);
    add_diced(patch, view, diced);
    EXPECT_EQ(diced.holes_against(fine), 0) << "view " << seed << ", patch " << i;
    EXPECT_EQ(diced.far_from(fine), 0) << "view " << seed << ", patch " << i;
    EXPECT_EQ(fine.far_from(diced), 0) << "view " << seed << ", patch " << i;
    // A point lies within half a pixel of its pixel's centre, across and down. So wherever all of a pixel's square is
    // covered, and a little round it for what a piece may be off the patch, there is a point in it or between some.
    Coverage points(screen.width, screen.height);
    add_points(patch, view, screen, points);
    constexpr int kSquare = 7;  // eighths: half a pixel's diagonal and a sixth
    EXPECT_EQ(points.holes_against(fine, kSquare), 0) << "view " << seed << ", patch " << i;
    EXPECT_EQ(points.far_from(fine), 0) << "view " << seed << ", patch " << i;
  }
  return true;
}

void compare_views(const Screen& screen) {
  int views = 0;
  for (std::uint64_t seed = 0; views < 500; ++seed) {
    if (compare(screen, 0.6 + 0.02 * static_cast<double>(seed % 50), seed)) ++views;
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Silhouette, IsWithinAPixelAndWithoutHolesAt320x240) { compare_views({320, 240, PixelFormat::rgb565}); }
TEST(Silhouette, IsWithinAPixelAndWithoutHolesAt480x320) { compare_views({480, 320, PixelFormat::rgb565}); }

}  // namespace
}  // namespace spanline::test
