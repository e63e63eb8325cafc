#include "core/base/pixel_format.hpp"

#include <gtest/gtest.h>

namespace spanline {
namespace {

TEST(PixelFormat, BytesPerLineRoundUpToWholeBytes) {
  EXPECT_EQ(bytes_per_line(PixelFormat::rgb565, 320), 640u);
  EXPECT_EQ(bytes_per_line(PixelFormat::grey8, 3), 3u);
  EXPECT_EQ(bytes_per_line(PixelFormat::grey4, 3), 2u);
  EXPECT_EQ(bytes_per_line(PixelFormat::grey4, 4), 2u);
  EXPECT_EQ(bytes_per_line(PixelFormat::mono1, 8), 1u);
  EXPECT_EQ(bytes_per_line(PixelFormat::mono1, 9), 2u);
}

}  // namespace
}  // namespace spanline
