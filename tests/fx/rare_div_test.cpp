#include "core/fx/rare_div.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/fx/bits.hpp"

namespace spanline {
namespace {

TEST(RareDiv, IsTheDivisionTowardsMinusInfinity) {
  std::mt19937_64 random(1);
  const auto number = [&](int bits) { return static_cast<std::int64_t>(random() >> (64 - bits)); };
  for (int i = 0; i < 200000; ++i) {
    const std::int64_t divisor = 1 + number(1 + static_cast<int>(random() % 62));
    const std::int64_t magnitude = number(1 + static_cast<int>(random() % 62));
    const std::int64_t dividend = (random() & 1) != 0 ? magnitude : -magnitude;
    ASSERT_EQ(rare_floor_div(dividend, divisor), floor_div(dividend, divisor)) << dividend << " / " << divisor;
  }
}

TEST(RareDiv, HoldsAtTheEnds) {
  for (const std::int64_t divisor : {std::int64_t{1}, std::int64_t{2}, std::int64_t{3}, INT64_MAX - 1, INT64_MAX}) {
    for (const std::int64_t dividend : {INT64_MIN, INT64_MIN + 1, -INT64_MAX / 2, std::int64_t{-1}, std::int64_t{0},
                                        std::int64_t{1}, INT64_MAX / 2, INT64_MAX}) {
      EXPECT_EQ(rare_floor_div(dividend, divisor), floor_div(dividend, divisor)) << dividend << " / " << divisor;
    }
  }
}

TEST(RareDiv, RoundsHalvesUpwards) {
  for (std::int64_t divisor = 1; divisor < 12; ++divisor) {
    for (std::int64_t dividend = -40; dividend <= 40; ++dividend) {
      EXPECT_EQ(rare_round_div(dividend, divisor), round_div(dividend, divisor)) << dividend << " / " << divisor;
    }
  }
}

}  // namespace
}  // namespace spanline
