#include "sim/fifo.hpp"

#include <gtest/gtest.h>

namespace spanline::host {
namespace {

// 30 frames of 100 lines a second: 333.3 us a line, 1666 references of 200 ns.
constexpr std::uint32_t kLineTime = 1666;

TEST(Fifo, NeedsALineWhereLinesCostNothing) { EXPECT_EQ(fifo_segments(std::vector<LineLoad>(100, {0, 4})), 4u); }

TEST(Fifo, NeedsLittleWhereTheGeneratorKeepsPace) {
  EXPECT_EQ(fifo_segments(std::vector<LineLoad>(100, {kLineTime, 10})), 1u);
}

TEST(Fifo, StoresTheCheapLinesBeforeTheDearOnes) {
  std::vector<LineLoad> lines(100, {0, 10});
  for (std::size_t i = 50; i < 60; ++i) lines[i].references = 4 * kLineTime;
  // Ten lines of four line times begin thirty before their turn: then lines 20 … 49 are stored.
  EXPECT_NEAR(fifo_segments(lines), 300, 12);
}

TEST(Fifo, MayStoreThePictureBeforehand) {
  std::vector<LineLoad> lines(100, {0, 10});
  lines[99].references = 1000 * kLineTime;
  EXPECT_EQ(fifo_segments(lines), 990u);
}

TEST(Fifo, OfNoLinesIsOne) { EXPECT_EQ(fifo_segments({}), 1u); }

}  // namespace
}  // namespace spanline::host
