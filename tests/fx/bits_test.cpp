#include "core/fx/bits.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(Bits, MulHighCutsTowardsMinusInfinity) {
  EXPECT_EQ(mul_high(std::int32_t{1} << 16, std::int32_t{1} << 16), 1);
  EXPECT_EQ(mul_high(std::int32_t{-1}, std::int32_t{1}), -1);
  EXPECT_EQ(mul_high(INT32_MIN, INT32_MIN), 1 << 30);
  EXPECT_EQ(mul_high(std::uint32_t{0xffffffffu}, std::uint32_t{0xffffffffu}), 0xfffffffeu);
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
