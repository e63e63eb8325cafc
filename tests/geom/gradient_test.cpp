// Gradients by one reciprocal against exact ones.
#include "core/geom/gradient.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geom/projection.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

struct Triangle {
  ScreenXY at[3];
  std::int32_t rise[2];
};

Triangle random_triangle(Random& random, int most_rise) {
  Triangle t;
  const int size = 1 << random.between(1, 12);
  const int x = random.between(-8000, 8000), y = random.between(-8000, 8000);
  for (ScreenXY& p : t.at) {
    p = {static_cast<std::int16_t>(x + random.below(size)), static_cast<std::int16_t>(y + random.below(size))};
  }
  const int rise = 1 << random.between(0, most_rise);
  for (std::int32_t& r : t.rise) r = random.between(-rise + 1, rise - 1);
  return t;
}

// What the plane is off at the triangle's corners, in units of the value.
template <int kBits>
long double worst_at_corners(const Triangle& t, const Gradient& gradient) {
  constexpr std::uint32_t kFrom = 1u << 30;
  const std::uint32_t at_zero = at_origin(kFrom, t.at[0], gradient);
  long double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const long double x = (t.at[i].x - 8) / 16.0L, y = (t.at[i].y - 8) / 16.0L;
    const long double climb = std::ldexp(gradient.right * x + gradient.down * y, -kBits);
    const long double start = std::ldexp(static_cast<long double>(static_cast<std::int32_t>(at_zero - kFrom)), -kBits);
    const long double exact = i == 0 ? 0 : t.rise[i - 1];
    // at_zero is modulo 2^32.
    worst = std::max(worst, std::fabs(std::remainder(start + climb - exact, std::ldexp(1.0L, 32 - kBits))));
  }
  return worst;
}

template <int kBits, int kMostRise>
void stay_close(std::uint64_t seed, long double coarse) {
  Random random(seed);
  int made = 0;
  for (int round = 0; round < oracle::rounds(200000); ++round) {
    const Triangle t = random_triangle(random, kMostRise);
    Gradient gradient;
    if (!small_gradient<1 << kMostRise>(t.at, t.rise[0], t.rise[1], kBits, gradient)) continue;
    ++made;
    ASSERT_LT(std::abs(gradient.right), kSteepest);
    ASSERT_LT(std::abs(gradient.down), kSteepest);
    const int most = std::max(std::abs(t.rise[0]), std::abs(t.rise[1]));
    // Half a unit of the gradient a pixel, over 256 both ways, the anchor's cut, and the reciprocal's error.
    const long double bound = std::ldexp(256 + 1.5L, -kBits) + std::ldexp(most, -24) + (most >> 18 != 0 ? coarse : 0);
    ASSERT_LT((worst_at_corners<kBits>(t, gradient)), bound) << "seed " << seed << ", round " << round;
  }
  EXPECT_GT(made, oracle::rounds(80000));
}

TEST(Gradient, OfDepthStaysCloseToTheCorners) { stay_close<5, 24>(1, 64); }
TEST(Gradient, OfBrightnessStaysCloseToTheCorners) { stay_close<16, 8>(2, 0); }

TEST(Gradient, IsRefusedForLargeSteepAndFlatTriangles) {
  Gradient g;
  EXPECT_FALSE((small_gradient<1 << 24>({{0, 0}, {4096, 0}, {0, 16}}, 1, 1, 5, g)));
  EXPECT_FALSE((small_gradient<1 << 24>({{0, 0}, {16, 16}, {32, 32}}, 1, 1, 5, g)));
  EXPECT_FALSE((small_gradient<1 << 24>({{0, 0}, {1, 0}, {0, 1}}, 1 << 23, 1, 5, g)));
  ASSERT_TRUE((small_gradient<1 << 24>({{0, 0}, {-4096, 0}, {0, -4096}}, 256, -512, 5, g)));
  EXPECT_EQ(g.right, -32);
  EXPECT_EQ(g.down, 64);
}

}  // namespace
}  // namespace spanline::test
