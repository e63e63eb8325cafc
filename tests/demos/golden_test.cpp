#include <gtest/gtest.h>

#include "golden/lines.hpp"

namespace spanline::golden {
namespace {

// draw_one(picture, stage, line, crc) is a Status.
template <typename DrawOne>
void expect_checksums(Slice<const Picture> pictures, const DrawOne& draw_one) {
  static demos::Stage stage;
  alignas(4) std::uint8_t line[kMostLineBytes];
  for (const Picture& picture : pictures) {
    std::uint32_t crc = 0;
    const Status status = draw_one(picture, stage, Slice<std::uint8_t>(line), crc);
    EXPECT_TRUE(status.ok()) << picture.name << ": " << status.where << " needs " << status.needed;
    EXPECT_EQ(crc, picture.crc) << picture.name << std::hex << ": 0x" << crc;
  }
}

template <Budget kPools>
Status draw_surfaces(const Picture& picture, demos::Stage& stage, Slice<std::uint8_t> line, std::uint32_t& crc) {
  static FrameMemory<kPools> memory;
  return draw(picture, memory.storage(), stage, line, crc);
}

TEST(Golden, EveryPictureHasItsChecksum) { expect_checksums(kPictures, draw_surfaces<kBudget>); }

// For which the image of kPictures has no room; what boards show is compared with the host.
TEST(Golden, EveryLargerPictureHasItsChecksum) {
  constexpr Budget kLargerBudget = [] {
    Budget budget = kBudget;
    budget.polygons = 128;
    budget.segments = 160;
    budget.curves = 96;
    budget.strands = 16;
    return budget;
  }();
  constexpr Picture kLargerPictures[] = {
      {"gears-wide-7", demos::gears, 7, kWide, 0x8947b9d0},
      {"gears-tall-150", demos::gears, 150, kTall, 0xa35d641d},
      {"dial-square-100", demos::dial, 100, kSquare, 0xcfb7df3b},
      {"dial-tall-0", demos::dial, 0, kTall, 0xdc1b1577},
      {"dial-oled-40", demos::dial, 40, kOled, 0xf487fd40},
  };
  expect_checksums(kLargerPictures, draw_surfaces<kLargerBudget>);
}

TEST(Golden, EveryPictureInLinesHasItsChecksum) {
  static LineMemory<kLineBudget> memory;
  expect_checksums(kLinePictures, [](const Picture& picture, demos::Stage& stage, Slice<std::uint8_t> line,
                                     std::uint32_t& crc) { return draw(picture, memory.storage(), stage, line, crc); });
}

TEST(Golden, Crc32IsTheUsualOne) {
  const std::uint8_t text[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  Crc32 sum;
  sum.add(text);
  EXPECT_EQ(sum.value(), 0xcbf43926u);
}

}  // namespace
}  // namespace spanline::golden
