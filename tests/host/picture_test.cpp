#include "sim/picture.hpp"

#include <gtest/gtest.h>

#include "assetc/text_file.hpp"
#include "host/support.hpp"
#include "sim/output_file.hpp"

namespace spanline::host {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes decoded(PixelFormat format, const Bytes& wire, std::uint16_t width) {
  Bytes rgb(std::size_t{3} * width);
  decode_line(format, wire.data(), width, rgb.data());
  return rgb;
}

TEST(DecodeLine, ExpandsRgb565ByBitReplication) {
  EXPECT_EQ(decoded(PixelFormat::rgb565, {0xff, 0xff, 0x08, 0x41, 0x84, 0x10}, 3),
            (Bytes{255, 255, 255, 8, 8, 8, 132, 130, 132}));
}

TEST(DecodeLine, TakesTheHighNibbleFirst) {
  EXPECT_EQ(decoded(PixelFormat::grey4, {0x0f, 0x70}, 3), (Bytes{0, 0, 0, 255, 255, 255, 119, 119, 119}));
}

TEST(DecodeLine, TakesTheHighBitFirst) {
  EXPECT_EQ(decoded(PixelFormat::mono1, {0x40}, 2), (Bytes{0, 0, 0, 255, 255, 255}));
}

TEST(DecodeLine, CopiesGrey) { EXPECT_EQ(decoded(PixelFormat::grey8, {7, 9}, 2), (Bytes{7, 7, 7, 9, 9, 9})); }

Picture gradient() {
  Picture picture(37, 11);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = static_cast<std::uint8_t>(i * 7);
  return picture;
}

TEST(Pictures, PngComesBackAsItWas) {
  if (!png_available()) GTEST_SKIP() << "this build has no libpng";
  const TemporaryFolder folder;
  const Picture picture = gradient();
  write_picture(folder.file("a.png"), picture);
  const Picture back = read_png(folder.file("a.png"));
  EXPECT_EQ(back.width, picture.width);
  EXPECT_EQ(back.rgb, picture.rgb);
}

TEST(Pictures, PgmIsBigEndian) {
  const std::string bytes = encode_pgm16(2, 1, {0x1234, 0xffff});
  EXPECT_EQ(bytes, "P5\n2 1\n65535\n\x12\x34\xff\xff");
}

TEST(OutputFile, ReplacesAWholeFile) {
  const TemporaryFolder folder;
  write_file(folder.file("a"), "first, longer");
  write_file(folder.file("a"), "second");
  EXPECT_EQ(read_file(folder.file("a")), "second");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

TEST(OutputFile, NumbersPaths) {
  EXPECT_EQ(numbered_path("a/b.png", 7, 89), "a/b-0007.png");
  EXPECT_EQ(numbered_path("b.c.png", 7, 12345), "b.c-00007.png");
  EXPECT_EQ(numbered_path("b", 7, 9), "b-0007");
}

}  // namespace
}  // namespace spanline::host
