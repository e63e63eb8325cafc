#include <gtest/gtest.h>

#include <vector>

#include "hal/panel/panels.hpp"

namespace spanline::hal {
namespace {

TEST(InitTable, ReadsCommandsArgumentsAndDelays) {
  constexpr std::uint8_t kTable[] = {0x11, 0 | kDelay, 120, 0x3A, 1, 0x55, 0xB1, 2 | kDelay, 7, 8, 9};
  InitReader reader(kTable);
  InitStep step;
  ASSERT_TRUE(reader.next(step));
  EXPECT_EQ(step.command, 0x11);
  EXPECT_TRUE(step.arguments.empty());
  EXPECT_EQ(step.delay_ms, 120);
  ASSERT_TRUE(reader.next(step));
  EXPECT_EQ(step.command, 0x3A);
  ASSERT_EQ(step.arguments.size(), 1u);
  EXPECT_EQ(step.arguments[0], 0x55);
  EXPECT_EQ(step.delay_ms, 0);
  EXPECT_FALSE(reader.at_end());
  ASSERT_TRUE(reader.next(step));
  EXPECT_EQ(step.arguments[1], 8);
  EXPECT_EQ(step.delay_ms, 9);
  EXPECT_FALSE(reader.next(step));
  EXPECT_TRUE(reader.at_end());
}

TEST(InitTable, OneThatBreaksOffIsNotWellFormed) {
  constexpr std::uint8_t kTable[] = {0x11, 0 | kDelay, 120, 0xE0, 3, 1, 2, 3};
  const auto begin = [&](std::uint32_t size) { return Slice<const std::uint8_t>(kTable, size); };
  for (const std::uint32_t size : {0u, 3u, 8u}) EXPECT_TRUE(well_formed(begin(size))) << size;
  for (const std::uint32_t size : {1u, 2u, 4u, 5u, 6u, 7u}) EXPECT_FALSE(well_formed(begin(size))) << size;
}

// The controllers' own tables leave to the driver what the driver sends, and leave the panel asleep.
TEST(InitTable, TablesAreWellFormedAndMindTheirOwnBusiness) {
  for (const DcsTraits* traits : {&kIli9341, &kSt7789, &kSt7789Square, &kSt7789Narrow, &kGc9a01, &kIli9488, &kSt7796}) {
    EXPECT_TRUE(well_formed(traits->init));
    InitReader reader(traits->init);
    for (InitStep step; reader.next(step);) {
      for (const int drivers : {0x01, 0x11, 0x20, 0x21, 0x29, 0x2A, 0x2B, 0x2C, 0x36, 0x3A}) {
        EXPECT_NE(step.command, drivers);
      }
    }
  }
  for (const SsdTraits* traits : {&kSsd0323, &kSsd1325, &kSsd1327, &kSsd1306}) {
    EXPECT_TRUE(well_formed(traits->init));
    InitReader reader(traits->init);
    for (InitStep step; reader.next(step);) {
      for (const int drivers : {0xA0, 0xA1, 0xA8, 0xAE, 0xAF}) EXPECT_NE(step.command, drivers);
    }
  }
}

}  // namespace
}  // namespace spanline::hal
