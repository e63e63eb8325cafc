#include "core/fx/inverse_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spanline::test {
namespace {

void expect_near(std::uint32_t value) {
  const InverseRoot root(value);
  ASSERT_GE(root.factor, (1u << 15) - 1) << value;
  ASSERT_LE(root.factor, 1u << 16) << value;
  ASSERT_NEAR(std::ldexp(root.factor, root.up - 31) * std::sqrt(value), 1, 1.0 / 8192) << value;
}

TEST(InverseRoot, IsWithinItsError) {
  for (std::uint32_t value = 1; value < 70'000; ++value) expect_near(value);
  for (std::uint64_t value = 70'000; value <= UINT32_MAX; value += value / 999) {
    expect_near(static_cast<std::uint32_t>(value));
  }
  expect_near(UINT32_MAX);
}

}  // namespace
}  // namespace spanline::test
