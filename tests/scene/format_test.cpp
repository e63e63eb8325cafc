#include "core/scene/format.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(Normal10, KeepsSignedComponents) {
  for (const int value : {-511, -256, -1, 0, 1, 255, 511}) {
    EXPECT_EQ(Normal10::pack(value, 0, 0).x(), value);
    EXPECT_EQ(Normal10::pack(0, value, 0).y(), value);
    EXPECT_EQ(Normal10::pack(0, 0, value).z(), value);
    const Normal10 all = Normal10::pack(value, -value, value);
    EXPECT_EQ(all.x(), value);
    EXPECT_EQ(all.y(), -value);
    EXPECT_EQ(all.z(), value);
  }
}

TEST(Transform, IdentityIsOneOnTheDiagonal) {
  const Transform identity = Transform::identity();
  for (int row = 0; row < 3; ++row) {
    EXPECT_EQ(identity.translation[row].raw, 0);
    for (int column = 0; column < 3; ++column) EXPECT_EQ(identity.matrix[row][column].raw, row == column ? 65536 : 0);
  }
}

}  // namespace
}  // namespace spanline
