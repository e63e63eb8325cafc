#include <gtest/gtest.h>

#include "golden/lines.hpp"

namespace spanline::golden {
namespace {

TEST(Golden, EveryPictureHasItsChecksum) {
  static FrameMemory<kBudget> memory;
  static demos::Stage stage;
  alignas(4) std::uint8_t line[kMostLineBytes];
  for (const Picture& picture : kPictures) {
    std::uint32_t crc = 0;
    const Status status = draw(picture, memory.storage(), stage, line, crc);
    EXPECT_TRUE(status.ok()) << picture.name << ": " << status.where << " needs " << status.needed;
    EXPECT_EQ(crc, picture.crc) << picture.name << std::hex << ": 0x" << crc;
  }
}

TEST(Golden, EveryPictureInLinesHasItsChecksum) {
  static LineMemory<kLineBudget> memory;
  static demos::Stage stage;
  alignas(4) std::uint8_t line[kMostLineBytes];
  for (const Picture& picture : kLinePictures) {
    std::uint32_t crc = 0;
    const Status status = draw_lines(picture, memory.storage(), stage, line, crc);
    EXPECT_TRUE(status.ok()) << picture.name << ": " << status.where << " needs " << status.needed;
    EXPECT_EQ(crc, picture.crc) << picture.name << std::hex << ": 0x" << crc;
  }
}

TEST(Golden, Crc32IsTheUsualOne) {
  const std::uint8_t text[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  Crc32 sum;
  sum.add(text);
  EXPECT_EQ(sum.value(), 0xcbf43926u);
}

}  // namespace
}  // namespace spanline::golden
