#include "core/fx/sine.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spanline {
namespace {

TEST(Sine, IsWithinItsBoundAtEveryAngle) {
  const double bound = std::ldexp(1.0, -24);
  for (int turn = 0; turn < 65536; ++turn) {
    const Turn16 angle{static_cast<std::uint16_t>(turn)};
    const double radians = turn * (2 * 3.14159265358979323846 / 65536);
    ASSERT_NEAR(sine(angle).raw / 1073741824.0, std::sin(radians), bound) << turn;
    ASSERT_NEAR(cosine(angle).raw / 1073741824.0, std::cos(radians), bound) << turn;
  }
}

TEST(Sine, IsExactAtTheQuarters) {
  EXPECT_EQ(sine({0}).raw, 0);
  EXPECT_EQ(sine({0x4000}).raw, Fx30::kOne);
  EXPECT_EQ(sine({0x8000}).raw, 0);
  EXPECT_EQ(sine({0xc000}).raw, -Fx30::kOne);
  EXPECT_EQ(cosine({0}).raw, Fx30::kOne);
  EXPECT_EQ(cosine({0x4000}).raw, 0);
}

}  // namespace
}  // namespace spanline
