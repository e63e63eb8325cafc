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

TEST(SideWalk, IsTheSameFromBothEndsAndNearlyExact) {
  Random random(1);
  for (int i = 0; i < oracle::rounds(5'000); ++i) {
    const ClipPoint p[4] = {any_clip_point(random), any_clip_point(random), any_clip_point(random),
                            any_clip_point(random)};
    const ClipPoint back[4] = {p[3], p[2], p[1], p[0]};
    const std::int64_t x[4] = {p[0].x, p[1].x, p[2].x, p[3].x};
    const auto steps = static_cast<std::uint32_t>(random.between(1, kMaxSteps));
    std::vector<ClipPoint> points, reversed;
    SideWalk walk(p, steps), walk_back(back, steps);
    for (std::uint32_t step = 0;; ++step) {
      points.push_back(walk.at());
      reversed.push_back(walk_back.at());
      const double exact = static_cast<double>(oracle::exact_cubic(x, step, steps)) / std::pow(steps, 3);
      ASSERT_NEAR(walk.at().x, exact, 2) << steps << " steps, " << step;
      ASSERT_TRUE(same_point(walk.at(), curve_point(p, step, steps))) << steps << " steps, " << step;
      if (step == steps) break;
      walk.step();
      walk_back.step();
    }
    std::reverse(reversed.begin(), reversed.end());
    for (std::size_t j = 0; j < points.size(); ++j) ASSERT_TRUE(same_point(points[j], reversed[j])) << j;
    ASSERT_TRUE(same_point(points.back(), p[3]));
  }
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

TEST(GridSide, FollowsTheVertexMap) {
  const ClipPoint p[4] = {{0, 0, 1 << 20}, {1 << 20, 0, 1 << 20}, {2 << 20, 5, 1 << 20}, {3 << 20, 0, 1 << 20}};
  for (std::uint32_t grid = 1; grid <= kMaxSteps; ++grid) {
    for (std::uint32_t own = 1; own <= grid; ++own) {
      std::vector<ClipPoint> vertices;
      SideWalk walk(p, own);
      for (std::uint32_t i = 0; i < own; ++i) {
        vertices.push_back(walk.at());
        walk.step();
      }
      vertices.push_back(walk.at());
      GridSide side(p, own, grid);
      for (std::uint32_t i = 0; i <= grid; ++i) {
        ASSERT_TRUE(same_point(side.at(), vertices[side_vertex(i, own, grid)])) << own << " of " << grid;
        if (i < grid) side.step();
      }
    }
  }
}

}  // namespace
}  // namespace spanline::test
