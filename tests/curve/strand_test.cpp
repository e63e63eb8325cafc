#include "core/curve/strand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "curve/curves.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

std::vector<CurvePoint> walked(const Strand& strand, int fineness) {
  StrandWalk walk(strand, fineness);
  std::vector<CurvePoint> points = {walk.at()};
  while (!walk.done()) {
    walk.next();
    points.push_back(walk.at());
  }
  return points;
}

struct Pixel {
  int x, y;
};
Pixel pixel_of(CurvePoint p) { return {p.x >> 4, p.y >> 4}; }

int apart(Pixel a, Pixel b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); }

// Downwards, without a gap.
void expect_monotone(const std::vector<CurvePoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_LE(apart(pixel_of(points[i - 1]), pixel_of(points[i])), 1) << "a gap at " << i;
    ASSERT_GE(points[i].y, points[i - 1].y - 1) << "upwards at " << i;
  }
}

// The ends of all strands in the curve's direction: each strand begins where the one before ended.
void expect_joined(const Cubic& curve, const std::vector<std::vector<CurvePoint>>& strands) {
  CurvePoint here = curve.p[0];
  for (const auto& points : strands) {
    const bool down = points.front() == here;
    ASSERT_TRUE(down || points.back() == here);
    here = down ? points.back() : points.front();
  }
  ASSERT_EQ(here, curve.p[3]);
}

std::vector<std::vector<CurvePoint>> strands_of(const Cubic& curve, int fineness) {
  const Strands strands(curve);
  std::vector<std::vector<CurvePoint>> all;
  for (unsigned i = 0; i < strands.count(); ++i) all.push_back(walked(strands[i], fineness));
  return all;
}

void expect_good_strands(const Cubic& curve, int fineness) {
  const auto strands = strands_of(curve, fineness);
  ASSERT_GE(strands.size(), 1u);
  ASSERT_LE(strands.size(), 3u);
  for (const auto& points : strands) expect_monotone(points);
  expect_joined(curve, strands);
}

TEST(Strands, TenThousandRandomCurvesAreMonotoneWithoutAGapAndJoined) {
  Random random(1);
  double sum = 0;
  constexpr int kCurves = oracle::rounds(10'000);
  for (int i = 0; i < kCurves; ++i) {
    const Cubic curve = random_cubic(random);
    expect_good_strands(curve, 0);
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
    std::set<std::pair<int, int>> pixels;
    std::size_t points = 0;
    for (const auto& strand : strands_of(curve, 0)) {
      points += strand.size();
      for (const CurvePoint p : strand) pixels.insert({p.x >> 4, p.y >> 4});
    }
    sum += static_cast<double>(points) / static_cast<double>(pixels.size());
  }
  RecordProperty("redundancy", std::to_string(sum / kCurves));
  EXPECT_LE(sum / kCurves, 1.5);
}

TEST(Strands, CurvesFarOffTheScreenAreNoWorse) {
  Random random(2);
  for (int i = 0; i < oracle::rounds(150); ++i) {
    expect_good_strands(random_far_cubic(random), i % 3);
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
}

TEST(Strands, CurvesThatBarelyTurnOrStandStill) {
  Random random(3);
  for (int i = 0; i < oracle::rounds(5'000); ++i) {
    Cubic curve;
    for (CurvePoint& p : curve.p) p = {random.below(40), random.below(6)};
    expect_good_strands(curve, i % 3);
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
  const Cubic point = {{{5, 5}, {5, 5}, {5, 5}, {5, 5}}};
  EXPECT_EQ(strands_of(point, 0).size(), 1u);
  const Cubic out_and_back = {{{8, 8}, {8, 808}, {8, 808}, {8, 8}}};
  EXPECT_EQ(strands_of(out_and_back, 0).size(), 2u);
}

// Every point of a walk lies on the curve, and the walk passes no place of it by.
TEST(Strands, FollowTheExactCurve) {
  Random random(4);
  for (int i = 0; i < oracle::rounds(60); ++i) {
    const Cubic curve = random_cubic(random);
    std::vector<CurvePoint> points;
    for (const auto& strand : strands_of(curve, 1)) points.insert(points.end(), strand.begin(), strand.end());
    std::vector<double> nearest(points.size(), 1e9);
    constexpr int kSamples = 8'000;
    for (int s = 0; s <= kSamples; ++s) {
      const At at = exact_at(curve, static_cast<double>(s) / kSamples);
      double best = 1e9;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const double d = std::max(std::abs(points[j].x / 16.0 - at.x), std::abs(points[j].y / 16.0 - at.y));
        nearest[j] = std::min(nearest[j], d);
        best = std::min(best, d);
      }
      ASSERT_LE(best, 0.45) << "curve " << i << " at " << s;
    }
    for (const double d : nearest) ASSERT_LE(d, 1.0 / 16 + 0.06) << "curve " << i;  // cut off, and half a sample
  }
}

}  // namespace
}  // namespace spanline::test
