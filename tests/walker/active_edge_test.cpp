// The 12.20 rule against quotient and remainder, which has no error, on every line of edges of all heights and slopes.
#include "core/vsg/active_edge.hpp"

#include <gtest/gtest.h>

#include "core/vsg/edge.hpp"
#include "oracle/random.hpp"
#include "vsg/scale.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

template <bool kDivide>
EdgeRun begin_run(ScreenXY top, ScreenXY bottom, std::int32_t line) {
  ActiveEdge edge{0, 0, 0, 0};
  FromVertex(PackedXY(top), line).run<kDivide>(edge, PackedXY(bottom), 0);
  return {edge.x, edge.dx, static_cast<std::int32_t>(edge.rest / ActiveEdge::kOneLine) + 1};
}

// Counts the lines of an edge, from `first` on, whose column is not the exact one; begins again where a run ends.
template <bool kDivide>
int wrong_lines(ScreenXY top, ScreenXY bottom, std::int32_t first, int& lines) {
  ScreenEdge edge;
  edge.top.at = top;
  edge.bottom.at = bottom;
  SegmentHalf exact = start_edge(edge, first, false);
  const std::int32_t end = first_centre(bottom.y);
  int wrong = 0;
  EdgeRun run = begin_run<kDivide>(top, bottom, first);
  for (std::int32_t line = first; line < end; ++line) {
    if (run.lines == 0) run = start_run(top, bottom, line);
    wrong += run.x >> ActiveEdge::kFraction != exact.column;
    ++lines;
    if (line + 1 == end) break;
    exact.step();
    --run.lines;
    if (run.lines != 0) run.x += run.dx;
  }
  return wrong;
}

// Edges that meet pixel centres exactly, and those that miss them by least, are where a rule fails first.
ScreenXY near_centre(Random& random, ScreenXY from, int dx, int dy) {
  const int x = from.x + dx, y = from.y + dy;
  const int mode = random.below(3);
  const int snapped = mode == 0 ? x : (x & ~15) + 8 + (mode == 1 ? 0 : random.between(-1, 1));
  return {static_cast<std::int16_t>(snapped), static_cast<std::int16_t>(y)};
}

class EdgeRule : public testing::TestWithParam<int> {
 protected:
  void try_edges(std::uint64_t count, int least_dy, int most_dy, int most_dx) {
    int wrong = 0, lines = 0;
    for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < count; seed += kShards) {
      Random random(seed);
      const int dy = random.between(least_dy, most_dy);
      const int dx = random.between(-most_dx, most_dx);
      const ScreenXY top{static_cast<std::int16_t>(random.between(-8000, 16000 - most_dx)),
                         static_cast<std::int16_t>(random.between(-8000, 16000 - most_dy))};
      const ScreenXY bottom = near_centre(random, top, dx, dy);
      const std::int32_t begin = first_centre(top.y), end = first_centre(bottom.y);
      if (begin >= end) continue;
      wrong += wrong_lines<true>(top, bottom, begin, lines);
      wrong += wrong_lines<true>(top, bottom, random.between(begin, end - 1), lines);
      if (dy >= SlopeByTable::kTallest) continue;
      wrong += wrong_lines<false>(top, bottom, begin, lines);
      wrong += wrong_lines<false>(top, bottom, random.between(begin, end - 1), lines);
    }
    EXPECT_EQ(wrong, 0) << "of " << lines;
    EXPECT_GT(lines, 1000);
  }
};

TEST_P(EdgeRule, IsExactForSmallEdges) { try_edges(scene_count(400000, 20000000), 1, 160, 700); }
TEST_P(EdgeRule, IsExactForWideEdges) { try_edges(scene_count(200000, 20000000), 120, 245, 2047); }
TEST_P(EdgeRule, IsExactUpToTheTallestOfThem) { try_edges(scene_count(100000, 4000000), 800, kTallEdge, 2047); }
TEST_P(EdgeRule, IsExactForTallAndWideEdges) { try_edges(scene_count(40000, 2000000), kTallEdge - 8, 16000, 15000); }
TEST_P(EdgeRule, IsExactForFlatEdges) { try_edges(scene_count(200000, 4000000), 1, 300, 15000); }

INSTANTIATE_TEST_SUITE_P(Shards, EdgeRule, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
