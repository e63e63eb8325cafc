#include "core/curve/seen_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve/steps.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

struct Curve {
  std::array<ClipPoint, 4> p{};
  std::array<ScreenXY, 4> at{};

  std::uint32_t square(const DiceView& view) const { return SeenCurve(p.data(), at.data(), 1).square_of_steps(view); }
  Curve reversed() const {
    Curve back = *this;
    std::reverse(back.p.begin(), back.p.end());
    std::reverse(back.at.begin(), back.at.end());
    return back;
  }
};

DiceView any_view(Random& random) {
  CameraRecord camera{};
  camera.near_plane = Fx16::from_raw(1 << 12);
  camera.focal = Fx12::from_int(random.between(20, kMaxFocalPx));
  return {camera, Screen{320, 240, PixelFormat::rgb565}, static_cast<std::uint32_t>(random.between(1, 32))};
}

// A curve that SeenCurve is for; only distances and places are of it.
Curve any_curve(Random& random) {
  const int bits = random.between(14, 30), size = 1 << random.between(4, 13);
  const std::int32_t nearest = random.between(1 << (bits - 1), 1 << bits);
  Curve curve;
  for (std::size_t i = 0; i < 4; ++i) {
    curve.p[i].w = nearest + random.between(0, nearest / 2);
    curve.at[i] = {static_cast<std::int16_t>(random.between(-size, size)),
                   static_cast<std::int16_t>(random.between(-size, size))};
  }
  return curve;
}

// 1/16 px that f'' / 6 is at most at one end, as the header has it.
double bend_at(const Curve& c, std::size_t end, std::size_t next, std::size_t farther, double depth) {
  const auto second = [&](auto coordinate) {
    return std::fabs(coordinate(end) - 2.0 * coordinate(next) + coordinate(farther));
  };
  const double across = std::hypot(second([&](std::size_t i) { return double(c.at[i].x); }),
                                   second([&](std::size_t i) { return double(c.at[i].y); }));
  const double ahead = second([&](std::size_t i) { return double(c.p[i].w); }) / c.p[end].w * depth;
  return std::max(across, ahead) * c.p[farther].w / c.p[end].w;
}

TEST(SeenCurve, TakesTheStepsThatItsSecondDifferencesAskFor) {
  Random random(1);
  for (int i = 0; i < oracle::rounds(20'000); ++i) {
    const DiceView view = any_view(random);
    const Curve curve = any_curve(random);
    const double bend = std::max(bend_at(curve, 0, 1, 2, view.depth), bend_at(curve, 3, 2, 1, view.depth));
    // Distances are cut off to 13 bits and more, each, and lengths are up to 1.02 too great.
    const double off = 1.5 * 4 * view.depth / (1 << 13) + 3, share = 0.75 / view.tolerance;
    const double square = curve.square(view);
    ASSERT_GE(square, (bend * 0.999 - off) * share) << "curve " << i;
    ASSERT_LE(square, (bend * 1.023 + off) * share + 1) << "curve " << i;
  }
}

TEST(SeenCurve, IsTheSameRunBackwards) {
  Random random(2);
  for (int i = 0; i < oracle::rounds(20'000); ++i) {
    const DiceView view = any_view(random);
    const Curve curve = any_curve(random);
    ASSERT_EQ(curve.square(view), curve.reversed().square(view)) << "curve " << i;
  }
}

TEST(SeenCurve, IsForCurvesInsideTheGuardBandThatAreNotMuchNearerAtOneEnd) {
  Random random(3);
  const DiceView view = any_view(random);
  const auto allowed = [&](std::int32_t nearest, std::int32_t farthest, ScreenXY at) {
    SeenPlaces seen;
    seen.widen({0, 0}, nearest);
    seen.widen(at, farthest);
    return seen.allow(view);
  };
  constexpr std::int32_t kBorder = kGuardPx * kSubpixels;
  const auto right = static_cast<std::int16_t>(view.centre_x + kBorder);
  const auto top = static_cast<std::int16_t>(view.centre_y - kBorder);
  EXPECT_TRUE(allowed(100'000, 150'000, {0, 0}));
  EXPECT_FALSE(allowed(100'000, 150'001, {0, 0}));
  EXPECT_FALSE(allowed(4'095, 5'000, {0, 0}));
  EXPECT_TRUE(allowed(100'000, 100'000, {static_cast<std::int16_t>(right - 1), static_cast<std::int16_t>(top + 1)}));
  EXPECT_FALSE(allowed(100'000, 100'000, {right, 0}));
  EXPECT_FALSE(allowed(100'000, 100'000, {0, top}));
  EXPECT_FALSE(allowed(100'000, 100'000, kNotProjected));
}

TEST(SeenCurve, AQuarterOfTheWayIsThatCurve) {
  Random random(4);
  for (int i = 0; i < oracle::rounds(5'000); ++i) {
    const DiceView view = any_view(random);
    const std::int32_t nearest = random.between(1 << 13, 1 << 14) << random.between(0, 16);
    std::array<Curve, 4> rows;
    for (Curve& row : rows) {
      row = any_curve(random);
      for (ClipPoint& p : row.p) p.w = nearest + random.between(0, nearest / 2);
    }
    Curve between;
    for (std::size_t j = 0; j < 4; ++j) {
      const auto blend = [&](auto coordinate) {
        return (27.0 * (coordinate(rows[0]) + coordinate(rows[1])) + 9.0 * coordinate(rows[2]) + coordinate(rows[3])) /
               64;
      };
      between.at[j] = {
          static_cast<std::int16_t>(std::lround(blend([&](const Curve& c) { return double(c.at[j].x); }))),
          static_cast<std::int16_t>(std::lround(blend([&](const Curve& c) { return double(c.at[j].y); })))};
      between.p[j].w = static_cast<std::int32_t>(blend([&](const Curve& c) { return double(c.p[j].w); }));
    }
    SeenPlaces places;
    for (const Curve& row : rows) {
      for (std::size_t j = 0; j < 4; ++j) places.widen(row.at[j], row.p[j].w);
    }
    const auto seen = [&](std::size_t row) { return SeenCurve(rows[row].p.data(), rows[row].at.data(), 1); };
    const double square =
        SeenCurve::quarter_way(seen(0), seen(1), seen(2), seen(3), places.cut()).square_of_steps(view);
    const double off = (1.5 * 4 * view.depth / (1 << 13) + 5) * 0.75 / view.tolerance + 1;
    ASSERT_NEAR(square, between.square(view), off + square / 500) << "curve " << i;
  }
}

TEST(SeenCurve, IsForWhateverIsBeforeTheNearPlane) {
  const std::array<ScreenXY, 4> at{ScreenXY{0, 0}, {100, 0}, {200, 100}, {200, 200}};
  CameraRecord camera{};
  camera.near_plane = Fx16::from_raw(1);
  camera.focal = Fx12::from_int(kMaxFocalPx);
  const DiceView view(camera, Screen{320, 240, PixelFormat::rgb565}, 1);
  for (const std::int32_t w : {1, 2, 3, 64, 1 << 13, 1 << 25, (1 << 25) + 1, INT32_MAX}) {
    const std::array<ClipPoint, 4> p{ClipPoint{0, 0, w}, {0, 0, w}, {0, 0, w}, {0, 0, w}};
    SeenPlaces places;
    for (const ScreenXY& place : at) places.widen(place, w);
    const SeenCurve curve(p.data(), at.data(), 1);
    const SeenCurve between = SeenCurve::quarter_way(curve, curve, curve, curve, places.cut());
    EXPECT_EQ(curve.square_of_steps(view), between.square_of_steps(view)) << w;
  }
}

TEST(StepsOf, AreTheLeastWhoseSquareIsEnough) {
  for (std::uint32_t square = 0; square < 5'000; ++square) {
    const auto exact = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(square))));
    EXPECT_EQ(steps_of(square), std::clamp(exact, 1u, kMaxSteps));
  }
}

}  // namespace
}  // namespace spanline::test
