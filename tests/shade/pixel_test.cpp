#include "core/shade/pixel.hpp"

#include <gtest/gtest.h>

#include <set>

namespace spanline {
namespace {

// What a panel reads from two bytes in the order of the wire.
unsigned from_wire(std::uint16_t pixel) { return (pixel & 255u) << 8 | pixel >> 8; }

TEST(Pixel, Rgb565IsInWireOrder) {
  EXPECT_EQ(from_wire(rgb565_wire(255, 0, 0)), 0xf800u);
  EXPECT_EQ(from_wire(rgb565_wire(0, 255, 0)), 0x07e0u);
  EXPECT_EQ(from_wire(rgb565_wire(0, 0, 255)), 0x001fu);
  for (unsigned v = 0; v < 256; ++v) {
    EXPECT_EQ(from_wire(rgb565_wire(v, v, v)), (v >> 3) << 11 | (v >> 2) << 5 | v >> 3);
  }
}

TEST(Pixel, LuminanceKeepsGreys) {
  for (unsigned v = 0; v < 256; ++v) {
    const auto grey = static_cast<std::uint8_t>(v);
    EXPECT_EQ(luminance({grey, grey, grey}), v);
  }
}

TEST(Pixel, BayerMatrixHoldsEveryThresholdOnce) {
  std::set<std::uint32_t> seen;
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      seen.insert(bayer8(x, y));
      EXPECT_EQ(bayer8(x, y), bayer8(x + 8, y + 16));
    }
  }
  EXPECT_EQ(seen.size(), 64u);
  EXPECT_EQ(*seen.rbegin(), 63u);
}

// Over a tile of 8 x 8 the levels average to the grey that was asked for.
TEST(Pixel, DitherKeepsTheMean) {
  for (std::uint32_t grey = 0; grey < 256; ++grey) {
    double levels = 0, lit = 0;
    for (std::uint32_t y = 0; y < 8; ++y) {
      for (std::uint32_t x = 0; x < 8; ++x) {
        levels += dither_grey4(grey, x, y);
        lit += dither_mono(grey, x, y);
      }
    }
    EXPECT_NEAR(levels / 64 * 17, grey, 0.3) << grey;
    EXPECT_NEAR(lit / 64 * 255, grey, 4.1) << grey;
  }
}

TEST(Pixel, BlackAndWhiteAreNeverDithered) {
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 8; ++x) {
      EXPECT_EQ(dither_grey4(0, x, y), 0u);
      EXPECT_EQ(dither_grey4(255, x, y), 15u);
      EXPECT_EQ(dither_mono(0, x, y), 0u);
      EXPECT_EQ(dither_mono(255, x, y), 1u);
      for (std::uint32_t level = 0; level < 16; ++level) EXPECT_EQ(dither_grey4(17 * level, x, y), level);
    }
  }
}

}  // namespace
}  // namespace spanline
