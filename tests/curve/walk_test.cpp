#include "core/curve/walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "curve/curves.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

struct Walked {
  std::vector<CurvePixel> pixels;
  std::uint32_t points = 0;

  double redundancy() const {
    const auto key = [](const CurvePixel& p) { return std::pair(p.y, p.x); };
    std::vector<CurvePixel> sorted = pixels;
    std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    const auto end = std::unique(sorted.begin(), sorted.end());
    return static_cast<double>(points) / static_cast<double>(end - sorted.begin());
  }
};

Walked walk(const Cubic& curve) {
  CurveWalk walker(curve);
  Walked walked;
  for (CurvePixel pixel; walker.next(pixel);) walked.pixels.push_back(pixel);
  walked.points = walker.points();
  return walked;
}

// What must hold of every walk: it starts and ends in the right pixels, has no gap and no pixel twice in a row.
void expect_connected(const Cubic& curve) {
  const auto pixel_of = [](CurvePoint p) {
    return CurvePixel{static_cast<std::int16_t>(p.x >> 4), static_cast<std::int16_t>(p.y >> 4)};
  };
  CurveWalk walker(curve);
  CurvePixel a;
  ASSERT_TRUE(walker.next(a));
  ASSERT_EQ(a, pixel_of(curve.p[0]));
  int i = 1;
  for (CurvePixel b; walker.next(b); a = b, ++i) {
    ASSERT_FALSE(a == b) << "twice in a row at " << i;
    ASSERT_LE(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1) << "a gap at " << i;
  }
  ASSERT_EQ(a, pixel_of(curve.p[3]));
}

// How far a place is from the square of a pixel, the larger of x and y.
double distance(At at, CurvePixel p) { return std::max({p.x - at.x, at.x - p.x - 1, p.y - at.y, at.y - p.y - 1, 0.0}); }

// Every pixel holds a point of the exact curve but for `slack` px, and no place of it is further than `gap` px from a
// pixel.
void expect_on_the_curve(const Cubic& curve, const Walked& walked, double slack, double gap) {
  constexpr int kSamples = 8'000;  // at most 0.12 px apart on a screen of 320 px
  std::vector<double> nearest(walked.pixels.size(), 1e9);
  for (int i = 0; i <= kSamples; ++i) {
    const At at = exact_at(curve, static_cast<double>(i) / kSamples);
    const int column = static_cast<int>(std::floor(at.x)), line = static_cast<int>(std::floor(at.y));
    double best = 1e9;
    for (std::size_t j = 0; j < nearest.size(); ++j) {
      const CurvePixel p = walked.pixels[j];
      if (std::abs(p.x - column) > 1 || std::abs(p.y - line) > 1) continue;  // a pixel away, at least
      const double d = distance(at, p);
      nearest[j] = std::min(nearest[j], d);
      best = std::min(best, d);
    }
    ASSERT_LE(best, gap) << "nothing near t = " << i << " / " << kSamples;
  }
  for (std::size_t j = 0; j < nearest.size(); ++j) ASSERT_LE(nearest[j], slack) << "pixel " << j << " is off the curve";
}

TEST(CurveWalk, TenThousandRandomCurvesHaveNoGapAndLittleRedundancy) {
  Random random(1);
  double sum = 0, worst = 0;
  constexpr int kCurves = oracle::rounds(10'000);
  for (int i = 0; i < kCurves; ++i) {
    const Cubic curve = random_cubic(random);
    expect_connected(curve);
    const Walked walked = walk(curve);
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
    sum += walked.redundancy();
    worst = std::max(worst, walked.redundancy());
  }
  RecordProperty("mean_thousandths", static_cast<int>(1000 * sum / kCurves));
  RecordProperty("worst_thousandths", static_cast<int>(1000 * worst));
  EXPECT_LE(sum / kCurves, 1.5);
}

TEST(CurveWalk, FollowsTheExactCurve) {
  Random random(2);
  for (int i = 0; i < oracle::rounds(60); ++i) {
    const Cubic curve = random_cubic(random);
    expect_on_the_curve(curve, walk(curve), 0.12, 0.6);  // half a sample and the cuts; half a step and its curvature
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
}

TEST(CurveWalk, TakesControlPointsFarOffTheScreen) {
  Random random(3);
  for (int i = 0; i < oracle::rounds(200); ++i) {
    expect_connected(random_far_cubic(random));
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
}

TEST(CurveWalk, DrawsShortAndDegenerateCurves) {
  const auto pixels = [](const Cubic& curve) {
    expect_connected(curve);
    return walk(curve).pixels.size();
  };
  EXPECT_EQ(pixels({{{5, 5}, {5, 5}, {5, 5}, {5, 5}}}), 1u);          // a point
  EXPECT_EQ(pixels({{{0, 8}, {160, 8}, {320, 8}, {480, 8}}}), 31u);   // a row, evenly run through
  EXPECT_EQ(pixels({{{8, 0}, {8, 0}, {8, 160}, {8, 160}}}), 11u);     // a column, from rest to rest
  EXPECT_EQ(pixels({{{0, 0}, {1600, 0}, {1600, 0}, {0, 0}}}), 151u);  // out to 75 px and back on itself
  EXPECT_EQ(pixels({{{-20, -20}, {-9, -9}, {2, 2}, {13, 13}}}), 3u);  // over the corner, by diagonals only
}

TEST(CurveWalk, NeighboursOfASplineMeet) {
  Random random(4);
  for (int i = 0; i < oracle::rounds(2'000); ++i) {
    CurvePoint p[5];
    for (CurvePoint& point : p) point = random_point(random, 320, 240);
    const Cubic b1 = from_b_spline(p[0], p[1], p[2], p[3]), b2 = from_b_spline(p[1], p[2], p[3], p[4]);
    EXPECT_EQ(b1.p[3], b2.p[0]);
    EXPECT_EQ(walk(b1).pixels.back(), walk(b2).pixels.front());
    const Cubic c1 = from_catmull_rom(p[0], p[1], p[2], p[3]), c2 = from_catmull_rom(p[1], p[2], p[3], p[4]);
    EXPECT_EQ(c1.p[3], c2.p[0]);
    EXPECT_EQ(c1.p[0], p[1]);
    const Cubic back = from_b_spline(p[3], p[2], p[1], p[0]);
    for (int j = 0; j < 4; ++j) EXPECT_EQ(back.p[j], b1.p[3 - j]);
  }
}

// The kinds of curve against their definitions, in floating point.
TEST(Cubic, ConversionsAreWithinAThirtySecondOfAPixel) {
  Random random(5);
  for (int i = 0; i < oracle::rounds(2'000); ++i) {
    CurvePoint p[4];
    for (CurvePoint& point : p) point = {random.between(-32768, 32767), random.between(-32768, 32767)};
    const Cubic quadratic = from_quadratic(p[0], p[1], p[2]);
    const Cubic b_spline = from_b_spline(p[0], p[1], p[2], p[3]);
    const Cubic catmull_rom = from_catmull_rom(p[0], p[1], p[2], p[3]);
    const auto near = [&](const Cubic& curve, double t, const double(&weights)[4]) {
      double x = 0;
      for (int j = 0; j < 4; ++j) x += weights[j] * p[j].x / 16;
      ASSERT_NEAR(exact_at(curve, t).x, x, 1.0 / 32 + 1e-9);
    };
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const double s = 1 - t, tt = t * t, ttt = tt * t;
      near(quadratic, t, {s * s, 2 * s * t, tt, 0});
      near(b_spline, t, {s * s * s / 6, (3 * ttt - 6 * tt + 4) / 6, (-3 * ttt + 3 * tt + 3 * t + 1) / 6, ttt / 6});
      near(catmull_rom, t,
           {(-ttt + 2 * tt - t) / 2, (3 * ttt - 5 * tt + 2) / 2, (-3 * ttt + 4 * tt + t) / 2, (ttt - tt) / 2});
    }
  }
}

}  // namespace
}  // namespace spanline::test
