#include "core/curve/side.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/curve/dice.hpp"
#include "curve/patch_scene.hpp"
#include "oracle/curve_exact.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

ClipPoint any_clip_point(Random& random) {
  constexpr std::int32_t kMost = (1 << 30) - 1;
  if (random.percent(10)) return {INT32_MAX, -INT32_MAX, INT32_MAX};
  return {random.between(-kMost, kMost), random.between(-kMost, kMost), random.between(-kMost, kMost)};
}

// A curve in the view, the last point as far away as the first or up to 8 times.
ClipPoint any_point_in_view(Random& random, int bits) {
  const std::int32_t w = random.between(1 << (bits - 3), (1 << bits) - 1);
  return {random.between(-w, w), random.between(-w, w), w};
}

std::vector<ClipPoint> points_of(const ClipPoint (&p)[4], std::uint32_t steps) {
  std::vector<ClipPoint> points;
  with_walk(p, steps, CurveReach(p).scale(steps), [&](auto& walk) {
    for (points.push_back(walk.at()); points.size() <= steps; points.push_back(walk.at())) walk.step();
  });
  return points;
}

void expect_symmetric_and_near(const ClipPoint (&p)[4], std::uint32_t steps) {
  const CurveScale scale = CurveReach(p).scale(steps);
  const double most_off = scale.is_short ? 1.5 * (1 << scale.down) : 2;
  const ClipPoint back[4] = {p[3], p[2], p[1], p[0]};
  const std::int64_t x[4] = {p[0].x, p[1].x, p[2].x, p[3].x}, w[4] = {p[0].w, p[1].w, p[2].w, p[3].w};
  const std::vector<ClipPoint> points = points_of(p, steps), reversed = points_of(back, steps);
  for (std::uint32_t step = 0; step <= steps; ++step) {
    const ClipPoint& at = points[step];
    ASSERT_NEAR(at.x, static_cast<double>(oracle::exact_cubic(x, step, steps)) / std::pow(steps, 3), most_off);
    ASSERT_NEAR(at.w, static_cast<double>(oracle::exact_cubic(w, step, steps)) / std::pow(steps, 3), most_off);
    ASSERT_TRUE(same_point(at, curve_point(p, step, steps))) << steps << " steps, " << step;
    ASSERT_TRUE(same_point(at, reversed[steps - step])) << steps << " steps, " << step;
  }
  ASSERT_TRUE(same_point(points.front(), p[0]) && same_point(points.back(), p[3]));
}

TEST(SideWalk, IsTheSameFromBothEndsAndNearlyExact) {
  Random random(1);
  for (int i = 0; i < oracle::rounds(5'000); ++i) {
    const ClipPoint p[4] = {any_clip_point(random), any_clip_point(random), any_clip_point(random),
                            any_clip_point(random)};
    expect_symmetric_and_near(p, static_cast<std::uint32_t>(random.between(1, kMaxSteps)));
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
}

TEST(SideWalk, InThirtyTwoBitsIsTheSameFromBothEndsAndNearEnough) {
  Random random(3);
  int in_words = 0;
  for (int i = 0; i < oracle::rounds(20'000); ++i) {
    const int bits = random.between(12, 30);
    const ClipPoint p[4] = {any_point_in_view(random, bits), any_point_in_view(random, bits),
                            any_point_in_view(random, bits), any_point_in_view(random, bits)};
    const auto steps = static_cast<std::uint32_t>(random.between(1, kMaxSteps));
    const CurveScale scale = CurveReach(p).scale(steps);
    const std::int32_t nearest = std::min({p[0].w, p[1].w, p[2].w, p[3].w});
    if (scale.is_short) {
      ++in_words;
      ASSERT_LE(1 << scale.down, nearest >> 16);
    }
    expect_symmetric_and_near(p, steps);
    if (testing::Test::HasFatalFailure()) FAIL() << "curve " << i;
  }
  EXPECT_GT(in_words, oracle::rounds(20'000) / 8);
}

TEST(SideWalk, NumbersOfStepsDoNotDependOnTheDirection) {
  Random random(2);
  const PatchView view = random_view(1, 1, 8);
  for (int i = 0; i < oracle::rounds(5'000); ++i) {
    const ClipPoint p[4] = {any_clip_point(random), any_clip_point(random), any_clip_point(random),
                            any_clip_point(random)};
    const ClipPoint back[4] = {p[3], p[2], p[1], p[0]};
    ASSERT_EQ(curve_steps(p, view.dice), curve_steps(back, view.dice));
  }
  const ClipPoint straight[4] = {{0, 0, 1 << 20}, {100, 30, 1 << 20}, {200, 60, 1 << 20}, {300, 90, 1 << 20}};
  EXPECT_EQ(curve_steps(straight, view.dice), 1u);
}

TEST(StepSideOff, FollowsTheVertexMap) {
  const ClipPoint p[4] = {{0, 0, 1 << 20}, {1 << 20, 0, 1 << 20}, {2 << 20, 5, 1 << 20}, {3 << 20, 0, 1 << 20}};
  for (std::uint32_t grid = 1; grid <= kMaxSteps; ++grid) {
    for (std::uint32_t own = 1; own <= grid; ++own) {
      const std::vector<ClipPoint> vertices = points_of(p, own);
      std::uint32_t i = 0;
      const auto expect = [&](const ClipPoint& at) {
        ASSERT_TRUE(same_point(at, vertices[side_vertex(i++, own, grid)])) << own << " of " << grid;
      };
      with_walk(p, own, CurveReach(p).scale(own), [&](auto& walk) { step_side_off(walk, grid, expect); });
      ASSERT_EQ(i, grid + 1);
    }
  }
}

}  // namespace
}  // namespace spanline::test
