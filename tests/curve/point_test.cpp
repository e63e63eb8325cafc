// Pieces of patches and the points stepped off them: what the proof that no hole is left stands on, and what it costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "core/curve/point_rows.hpp"
#include "curve/patch_scene.hpp"
#include "oracle/random.hpp"
#include "vsg/scale.hpp"

namespace spanline::test {
namespace {

constexpr Screen kLarge{480, 320, PixelFormat::rgb565};

PointWindow all_of(const Screen& screen) { return {0, screen.height, screen.width}; }

template <typename Use>
void each_piece(const PatchPoints& points, const PatchView& view, const PointWindow& window, const Use& use) {
  const ClipPatch patch = view.patch(points);
  PieceCutter cutter(patch, view.projection, window, false);
  for (ScreenPiece piece; cutter.next(piece);) use(piece);
}

using Row = std::vector<PointPixel>;
std::vector<Row> rows_of(const ScreenPiece& piece) {
  std::vector<Row> rows;
  PointRows walk(piece);
  for (std::uint32_t i = 0; i <= piece.rows; ++i, walk.step()) {
    walk.step_off(rows.emplace_back(piece.columns + 1).data());
  }
  return rows;
}

bool touch(const PointPixel& a, const PointPixel& b) { return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1; }

// Pairs of neighbours on the grid whose pixels do not touch.
int gaps(const std::vector<Row>& rows) {
  int count = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      if (j > 0 && !touch(rows[i][j - 1], rows[i][j])) ++count;
      if (i > 0 && !touch(rows[i - 1][j], rows[i][j])) ++count;
    }
  }
  return count;
}

TEST(Points, NeighboursTouch) {
  const std::uint64_t views = scene_count(24, 300);
  for (std::uint64_t view = 0; view < views; ++view) {
    const PatchView about = random_view(view, 0.05 + 1.5 * static_cast<double>(view) / static_cast<double>(views), 8,
                                        view % 2 ? kLarge : kPatchScreen);
    for (const PatchPoints& patch : view % 3 == 0 ? random_patches(view, 3) : teapot_patches()) {
      each_piece(patch, about, all_of(kLarge),
                 [&](const ScreenPiece& piece) { ASSERT_EQ(gaps(rows_of(piece)), 0) << "view " << view; });
    }
  }
}

// All ways that four pixels can follow each other round a quadrangle, each touching the next: the one way to have
// another pixel's centre inside is the one that is filled.
TEST(Points, OnlyADiamondHasAPixelInside) {
  const auto inside = [](const std::vector<std::pair<int, int>>& ring, int x, int y) {
    int turns = 0;  // of the ring about the pixel, as crossings of the ray to the right
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto [ax, ay] = ring[i];
      const auto [bx, by] = ring[(i + 1) % ring.size()];
      if ((ay <= y) == (by <= y)) continue;
      const double at = ax + double(y - ay) * (bx - ax) / (by - ay);
      if (at > x) turns += by > ay ? 1 : -1;
    }
    return turns != 0;
  };
  int diamonds = 0;
  for (int code = 0; code < 9 * 9 * 9; ++code) {
    std::vector<std::pair<int, int>> ring{{0, 0}};
    for (int i = 0, rest = code; i < 3; ++i, rest /= 9) {
      ring.emplace_back(ring.back().first + rest % 3 - 1, ring.back().second + rest / 3 % 3 - 1);
    }
    if (std::abs(ring[3].first) > 1 || std::abs(ring[3].second) > 1) continue;
    const auto pixel = [&](std::size_t i) {
      return PointPixel{static_cast<std::int16_t>(ring[i].first), static_cast<std::int16_t>(ring[i].second), 0};
    };
    const PointPixel above[2] = {pixel(0), pixel(1)}, below[2] = {pixel(3), pixel(2)};
    std::set<std::pair<int, int>> filled;
    fill_diamonds(above, below, 1, [&](std::uint32_t, const PointPixel& p) { filled.insert({p.x, p.y}); });
    diamonds += static_cast<int>(filled.size());
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        const bool corner = std::find(ring.begin(), ring.end(), std::pair(x, y)) != ring.end();
        EXPECT_EQ(!corner && inside(ring, x, y), filled.count({x, y}) == 1) << code << ": " << x << ", " << y;
      }
    }
  }
  EXPECT_EQ(diamonds, 8);
}

struct Place3 {
  double x, y, depth;
};
double bernstein(int i, double t) {
  const double s = 1 - t;
  return i == 0 ? s * s * s : i == 1 ? 3 * s * s * t : i == 2 ? 3 * s * t * t : t * t * t;
}
Place3 exact_on(const ClipPatch& patch, const PatchView& view, double u, double v) {
  double x = 0, y = 0, w = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double weight = bernstein(i, v) * bernstein(j, u);
      x += weight * patch.at[i][j].x;
      y += weight * patch.at[i][j].y;
      w += weight * patch.at[i][j].w;
    }
  }
  return {view.projection.centre_x / 16.0 + kGuardPx * x / w, view.projection.centre_y / 16.0 + kGuardPx * y / w,
          65536.0 * view.projection.near_w / w};
}

// What a piece's walk leads to against the patch itself.
TEST(Points, PiecesFollowThePatch) {
  double farthest = 0, deepest = 0;
  for (std::uint64_t view = 0; view < 20; ++view) {
    const PatchView about = random_view(view, 0.15 + 0.06 * static_cast<double>(view), 8);
    for (const PatchPoints& points : teapot_patches()) {
      const ClipPatch patch = about.patch(points);
      each_piece(points, about, all_of(kPatchScreen), [&](const ScreenPiece& piece) {
        PointRows walk(piece);
        for (std::uint32_t i = 0; i <= piece.rows; ++i, walk.step()) {
          for (int j = 0; j < 4; j += 3) {
            double along = (j == 3 ? 1.0 : 0.0), across = static_cast<double>(i) / piece.rows;
            if (piece.turned) std::swap(along, across);
            const Place3 exact = exact_on(patch, about, (piece.u.index + along) / (1u << piece.u.level),
                                          (piece.v.index + across) / (1u << piece.v.level));
            const double x = walk.control(kPointX, j) / double(1 << kPointBits);
            const double y = walk.control(kPointY, j) / double(1 << kPointBits);
            farthest = std::max(farthest, std::hypot(x - exact.x, y - exact.y));
            deepest = std::max(deepest, std::abs(walk.control(kPointDepth, j) / 1024.0 - exact.depth));
          }
        }
      });
    }
  }
  EXPECT_LE(farthest, 1.0 / 6);
  EXPECT_GT(farthest, 0);
  RecordProperty("farthest_px", std::to_string(farthest));
  RecordProperty("deepest", std::to_string(deepest));
}

TEST(Points, AWalkEndsWhereItShould) {
  oracle::Random random(2);
  for (int i = 0; i < 20'000; ++i) {
    const auto n = static_cast<std::uint32_t>(random.between(1, static_cast<int>(kMostPieceSteps)));
    const int leg = static_cast<int>(n << kPointBits) / 3;
    std::int32_t p[4] = {random.between(-1000, 2500) << kPointBits, 0, 0, 0};
    for (int k = 1; k < 4; ++k) p[k] = p[k - 1] + random.between(-leg, leg);
    CurveBasis<std::int32_t> walk = piece_basis(p, n);
    for (std::uint32_t step = 0; step <= n; ++step, walk.step()) {
      double exact = 0;
      for (int k = 0; k < 4; ++k) exact += bernstein(k, double(step) / n) * p[k];
      ASSERT_LE(std::abs(walk.b0.value() - exact), (1 << kPointBits) / 200.0) << step << " of " << n;
    }
  }
}

TEST(Points, PiecesDoNotDependOnTheWindow) {
  const PatchView view = random_view(5, 0.8, 8);
  using Name = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
  const auto name = [](const ScreenPiece& p) {
    return Name{p.u.index, p.u.level, p.v.index, p.v.level, p.rows, p.columns};
  };
  for (const PatchPoints& patch : teapot_patches()) {
    std::set<Name> whole, parts;
    each_piece(patch, view, all_of(kPatchScreen), [&](const ScreenPiece& p) { whole.insert(name(p)); });
    for (int top = 0; top < 240; top += 7) {
      each_piece(patch, view, {top, std::min(top + 7, 240), 320}, [&](const ScreenPiece& p) { parts.insert(name(p)); });
    }
    EXPECT_EQ(whole, parts);
  }
}

// A patch that is but a curve, its rows being points, seen nearly along itself: what perspective wants cut is cut along
// the curve, so that there is not much more to look at than the pixels that it crosses.
TEST(Points, APatchThatIsACurveIsCutAlongItAlone) {
  const PatchView view = random_view(1, 1, 8);
  const std::int32_t nearest = view.projection.near_w;
  for (const bool rows_are_points : {true, false}) {
    for (int end = -2; end <= 60; ++end) {  // from behind the eye, from before it, to far off
      ClipPatch patch{};
      for (int i = 0; i < 4; ++i) {
        const ClipPoint p{nearest / 700 * (i % 2), nearest / 200 * (1 + i / 2), nearest * (3 + i * end) / 3};
        for (int j = 0; j < 4; ++j) (rows_are_points ? patch.at[i][j] : patch.at[j][i]) = p;
      }
      PieceCutter cutter(patch, view.projection, all_of(kPatchScreen), false);
      std::uint32_t pieces = 0;
      for (ScreenPiece piece; cutter.next(piece);) ++pieces;
      EXPECT_GE(pieces, 1u) << end;
      EXPECT_LE(cutter.looks(), 130u) << end;
    }
  }
}

// The ground from behind the eye to the horizon, as one patch, its depth along one direction of it or slantwise: no
// pixel below the horizon's haze is left out.
TEST(Points, TheGroundReachesToTheFeet) {
  PatchView view = random_view(1, 1, 8);
  constexpr std::int32_t kDepth = 1 << 27, kFeet = kDepth / 400;  // w at the screen's last line
  for (const bool slant : {false, true}) {
    ClipPatch patch{};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const int across = slant ? i - j : 2 * j - 3, along = slant ? i + j - 3 : 2 * i - 3;
        patch.at[i][j] = {kDepth / 3 * across / 2, kFeet / kGuardPx * 120, kDepth / 3 * along / 2};
      }
    }
    view.projection.near_w = kFeet / 4;
    PieceCutter cutter(patch, view.projection, all_of(kPatchScreen), false);
    std::set<std::pair<int, int>> hit;
    const auto note = [&](std::uint32_t, const PointPixel& p) { hit.insert({p.x, p.y}); };
    for (ScreenPiece piece; cutter.next(piece);) {
      const std::vector<Row> rows = rows_of(piece);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const PointPixel& p : rows[i]) note(0, p);
        if (i > 0) fill_diamonds(rows[i - 1].data(), rows[i].data(), piece.columns, note);
      }
    }
    for (int y = 124; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) ASSERT_EQ(hit.count({x, y}), 1u) << slant << ": " << x << ", " << y;
    }
    EXPECT_LE(cutter.looks(), slant ? 60'000u : 8'000u);
  }
}

// The worst there is: control points anywhere, before the eye, behind it and beside it, any near plane.
TEST(Points, CutsAreBounded) {
  oracle::Random random(3);
  PatchView view = random_view(1, 1, 8);
  std::uint32_t most = 0;
  for (std::uint64_t i = scene_count(60, 2'000); i > 0; --i) {
    view.projection.near_w = 1 << random.below(28);
    const int aside = 1 << random.between(4, 29), deep = 1 << random.between(4, 29);
    ClipPatch patch;
    for (auto& row : patch.at) {
      for (ClipPoint& p : row) {
        p = {random.between(-aside, aside), random.between(-aside, aside), random.between(-deep, deep)};
      }
    }
    PieceCutter cutter(patch, view.projection, all_of(kPatchScreen), false);
    for (ScreenPiece piece; cutter.next(piece);) {
    }
    most = std::max(most, cutter.looks());
  }
  EXPECT_LE(most, 1'500'000u);
  RecordProperty("looks", std::to_string(most));
}

// Points stepped to over the pixels that they lie in, a patch at a time, the whole picture being one band.
TEST(Points, TheTeapotTakesNoMoreThanTwoAndAHalfPointsAPixel) {
  const auto patches = teapot_patches();
  const std::uint64_t views = scene_count(20, 1000);
  double sum = 0, worst = 0;
  for (std::uint64_t view = 1; view <= views; ++view) {
    const PatchView about = random_view(view, 1, 8);
    std::size_t points = 0, pixels = 0;
    for (const PatchPoints& patch : patches) {
      std::set<std::pair<int, int>> hit;
      each_piece(patch, about, all_of(kPatchScreen), [&](const ScreenPiece& piece) {
        for (const Row& row : rows_of(piece)) {
          points += row.size();
          for (const PointPixel& p : row) hit.insert({p.x, p.y});
        }
      });
      pixels += hit.size();
    }
    const double redundancy = static_cast<double>(points) / static_cast<double>(pixels);
    sum += redundancy;
    worst = std::max(worst, redundancy);
  }
  EXPECT_LE(sum / static_cast<double>(views), 2.5);
  EXPECT_LE(worst, 3.0);
  RecordProperty("mean", std::to_string(sum / static_cast<double>(views)));
  RecordProperty("worst", std::to_string(worst));
}

}  // namespace
}  // namespace spanline::test
