#include "budget/line_ring.hpp"

#include <gtest/gtest.h>

#include <random>

namespace spanline::host {
namespace {

using Lines = std::vector<LineTime>;

// The same by time steps: one cycle after the other, who computes and who sends.
bool starves(const Lines& lines, std::size_t buffers) {
  std::size_t computed = 0, sent = 0;
  std::uint64_t left = lines[0].compute, wire = 0;
  bool begun = false, starved = false;
  while (sent < lines.size()) {
    while (computed < lines.size() && left == 0 && computed - sent < buffers) {
      ++computed;
      left = computed < lines.size() ? lines[computed].compute : 0;
      if (computed - sent == buffers) break;
    }
    begun = begun || computed == buffers;
    if (begun && wire == 0) {
      if (computed > sent) {
        wire = lines[sent].wire;
      } else {
        starved = true;
      }
    }
    if (computed < lines.size() && computed - sent < buffers && left > 0) --left;
    if (begun && wire > 0 && --wire == 0) ++sent;
  }
  return starved;
}

TEST(LineRing, IsTwoWhereEveryLineIsFasterThanTheWire) { EXPECT_EQ(smallest_ring(Lines(100, {60, 100})), 2u); }

TEST(LineRing, NeedsAsManyMoreAsAHardLineTakesWires) {
  Lines lines(100, {50, 100});
  lines[50].compute = 350;
  EXPECT_EQ(smallest_ring(lines), 5u);
}

TEST(LineRing, DoesNotExistWhereComputingIsTooSlow) {
  EXPECT_EQ(smallest_ring(Lines(10, {1000, 1})), std::nullopt);
  EXPECT_EQ(smallest_ring({}), std::nullopt);
}

TEST(LineRing, IsTheSmallestByTimeSteps) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    Lines lines(3 + random() % 20);
    for (LineTime& line : lines) line = {1 + random() % 20, 5 + random() % 10};
    const std::optional<std::uint32_t> ring = smallest_ring(lines);
    std::optional<std::uint32_t> expected;
    for (std::uint32_t buffers = 1; buffers < lines.size() && !expected; ++buffers) {
      if (!starves(lines, buffers)) expected = buffers;
    }
    ASSERT_EQ(ring, expected) << "trial " << trial;
  }
}

TEST(LineRing, TwoBuffersOverlapComputingAndSending) {
  EXPECT_EQ(frame_time(Lines(10, {60, 100}), 2), 60u + 10 * 100);
  EXPECT_EQ(frame_time(Lines(10, {100, 60}), 2), 10u * 100 + 60);
  EXPECT_EQ(frame_time(Lines(10, {100, 60}), 1), 10u * 160);
}

}  // namespace
}  // namespace spanline::host
