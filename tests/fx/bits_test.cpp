#include "core/fx/bits.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(Bits, MulHighCutsTowardsMinusInfinity) {
  EXPECT_EQ(mul_high(std::int32_t{1} << 16, std::int32_t{1} << 16), 1);
  EXPECT_EQ(mul_high(std::int32_t{-1}, std::int32_t{1}), -1);
  EXPECT_EQ(mul_high(INT32_MIN, INT32_MIN), 1 << 30);
}

TEST(Bits, HalvesMakeTheSameHighProduct) {
  const auto same = [](std::int32_t a, std::int32_t b) {
    EXPECT_EQ(mul_high_by_halves(a, b), static_cast<std::int32_t>((std::int64_t{a} * b) >> 32)) << a << " * " << b;
  };
  const std::int32_t ends[] = {INT32_MIN, INT32_MIN + 1, -65537, -65536, -65535,    -1,           0,
                               1,         65535,         65536,  65537,  INT32_MAX, INT32_MAX - 1};
  for (const std::int32_t a : ends) {
    for (const std::int32_t b : ends) same(a, b);
  }
  std::uint32_t state = 1;
  const auto next = [&state] { return static_cast<std::int32_t>(state = state * 1664525u + 1013904223u); };
  for (int i = 0; i < 100000; ++i) {
    const std::int32_t a = next();
    same(a, next());
  }
}

TEST(Bits, ShiftRoundTakesHalvesUpwards) {
  EXPECT_EQ(shift_round(7, 2), 2);
  EXPECT_EQ(shift_round(6, 2), 2);
  EXPECT_EQ(shift_round(5, 2), 1);
  EXPECT_EQ(shift_round(-6, 2), -1);
  EXPECT_EQ(shift_round(-7, 2), -2);
  EXPECT_EQ(shift_round(std::int64_t{3} << 40, 41), 2);
}

TEST(Bits, Saturate32IsSymmetric) {
  EXPECT_EQ(saturate32(INT64_MAX), INT32_MAX);
  EXPECT_EQ(saturate32(INT64_MIN), -INT32_MAX);
  EXPECT_EQ(saturate32(INT32_MIN), -INT32_MAX);
  EXPECT_EQ(saturate32(-5), -5);
}

TEST(Bits, DivisionsByName) {
  for (int dividend = -50; dividend <= 50; ++dividend) {
    for (int divisor = 1; divisor <= 9; ++divisor) {
      const int floor = floor_div(dividend, divisor);
      EXPECT_LE(floor * divisor, dividend);
      EXPECT_GT((floor + 1) * divisor, dividend);
      // The nearest: |2 (dividend - q divisor)| <= divisor, an exact half goes up.
      const int twice_rest = 2 * (dividend - round_div(dividend, divisor) * divisor);
      EXPECT_GE(twice_rest, -divisor) << dividend << " / " << divisor;
      EXPECT_LT(twice_rest, divisor) << dividend << " / " << divisor;
    }
  }
}

}  // namespace
}  // namespace spanline
