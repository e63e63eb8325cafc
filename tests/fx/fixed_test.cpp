#include "core/fx/fixed.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(Fixed, WholeNumbersAndSums) {
  EXPECT_EQ(Fx16::from_int(-3).raw, -3 * 65536);
  EXPECT_EQ((Fx16::from_int(2) + Fx16::from_raw(1)).raw, 131073);
  EXPECT_EQ(-(Fx12::from_int(1) - Fx12::from_int(4)), Fx12::from_int(3));
  EXPECT_LT(Fx30::from_int(-1), Fx30::from_int(1));
  EXPECT_EQ(Fx30::kOne, 1 << 30);
}

TEST(Turn16, WrapsByItself) { EXPECT_EQ((Turn16{0xc000} + Turn16{0x8000}).raw, 0x4000); }

}  // namespace
}  // namespace spanline
