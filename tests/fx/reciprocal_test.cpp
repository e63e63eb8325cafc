#include "core/fx/reciprocal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace spanline {
namespace {

void expect_close(std::uint32_t w) {
  const long double exact = std::ldexp(1.0L, 61) / w;
  const std::uint32_t r = reciprocal_normalised(w);
  ASSERT_LE(r, 0x7fffffffu) << w;
  // At the lower end 2^61 / w is 2^31, which is out of the range by one unit: a relative 2^-31.
  ASSERT_LE(std::fabs(r / exact - 1), std::ldexp(1.0L, -25)) << w;
}

TEST(Reciprocal, IsWithinItsBound) {
  const std::uint64_t stride = std::getenv("SPANLINE_FULL") != nullptr ? 1 : 997;
  for (std::uint64_t w = std::uint64_t{1} << 30; w < (std::uint64_t{1} << 31); w += stride)
    expect_close(static_cast<std::uint32_t>(w));
}

TEST(Reciprocal, IsWithinItsBoundAtTheEndsOfEverySeed) {
  for (std::uint32_t seed = 256; seed < 512; ++seed) {
    expect_close(seed << 22);
    expect_close((seed << 22) + 1);
    expect_close((seed << 22) + 0x3fffff);
  }
}

}  // namespace
}  // namespace spanline
