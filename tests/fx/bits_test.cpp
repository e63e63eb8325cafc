#include "core/fx/bits.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(Bits, MulHighCutsTowardsMinusInfinity) {
  EXPECT_EQ(mul_high(std::int32_t{1} << 16, std::int32_t{1} << 16), 1);
  EXPECT_EQ(mul_high(std::int32_t{-1}, std::int32_t{1}), -1);
  EXPECT_EQ(mul_high(INT32_MIN, INT32_MIN), 1 << 30);
}

TEST(Bits, HighProductsAreRoundedByTheBitBelow) {
  std::uint32_t state = 2;
  const auto next = [&state] { return static_cast<std::int32_t>(state = state * 1664525u + 1013904223u); };
  for (int i = 0; i < 100000; ++i) {
    const std::int32_t a = next(), b = next();
    const std::uint32_t low = static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
    ASSERT_EQ(mul_high_round(a, b), mul_high_by_halves(a, b) + static_cast<std::int32_t>(low >> 31)) << a << " * " << b;
  }
  EXPECT_EQ(mul_high_round(1 << 30, 2), 1);
  EXPECT_EQ(mul_high_round(-1 << 30, 2), 0);
}

TEST(Bits, HalvesAreComparedEachOnItsOwn) {
  EXPECT_EQ(least_halves(pack_halves(-3, 7), pack_halves(2, -32768)), pack_halves(-3, -32768));
  EXPECT_EQ(greatest_halves(pack_halves(-3, 7), pack_halves(2, -32768)), pack_halves(2, 7));
  EXPECT_EQ(least_halves(pack_halves(32767, -1), pack_halves(-32768, 0)), pack_halves(-32768, -1));
  EXPECT_EQ(greatest_halves(pack_halves(32767, -1), pack_halves(-32768, 0)), pack_halves(32767, 0));
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

// Where the core has instructions for them, these are tested.
TEST(Bits, HalvesAreTakenByThemselves) {
  std::uint32_t state = 1;
  const auto next = [&state] { return state = state * 1664525u + 1013904223u; };
  const auto low = [](std::uint32_t v) { return static_cast<std::int16_t>(v & 0xffffu); };
  const auto high = [](std::uint32_t v) { return static_cast<std::int16_t>(v >> 16); };
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t a = next() ^ next() >> 16, b = next() ^ next() >> 16, sum = next();
    EXPECT_EQ(pack_halves(low(a), high(a)), a);
    EXPECT_EQ(low_half(a), low(a));
    EXPECT_EQ(high_half(a), high(a));
    const std::uint32_t difference = subtract_halves(a, b);
    EXPECT_EQ(low(difference), static_cast<std::int16_t>(low(a) - low(b)));
    EXPECT_EQ(high(difference), static_cast<std::int16_t>(high(a) - high(b)));
    const std::int64_t products = std::int64_t{low(a)} * low(b) + std::int64_t{high(a)} * high(b);
    EXPECT_EQ(add_products(a, b, sum), static_cast<std::uint32_t>(sum + products));
    if (high(a) != INT16_MIN) {
      EXPECT_EQ(cross_halves(a, b), std::int64_t{low(a)} * high(b) - std::int64_t{high(a)} * low(b));
    }
    const auto x = static_cast<std::int32_t>(a), y = static_cast<std::int32_t>(b);
    const std::int32_t start = static_cast<std::int32_t>(sum) >> 1;
    EXPECT_EQ(add_high(x, y, start), start + static_cast<std::int32_t>((std::int64_t{x} * y) >> 32));
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
