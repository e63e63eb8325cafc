// Edges that begin where cells of grids do: what two grids with a common side cover, together and apart.
#include "core/vsg/grid_start.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

struct Vertex {
  std::uint16_t next = 0, parts = 0;
  ScreenXY at;
  std::uint32_t stride = 0;
  bool first_row = false;
};

constexpr int kSide = 4, kLines = 20, kFirst = 1;  // vertices of a grid's side
constexpr int kPlace = kSide * kSide;
using Grids = std::vector<Vertex>;

// Two grids, the last column of one in the place of the other's first. `which`: bits of those whose cells are drawn.
Grids make_grids(Random random, unsigned which) {
  Grids grids(kFirst + 2 * kPlace + 1);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < 2 * kSide - 1; ++column) {
      const ScreenXY at{static_cast<std::int16_t>(100 * column + random.between(-60, 60)),
                        static_cast<std::int16_t>(80 * row + random.between(-50, 50))};
      const bool apart = random.percent(20), drawn = random.percent(80);
      for (int grid = 0; grid < 2; ++grid) {
        const int own = column - grid * (kSide - 1);
        if (own < 0 || own >= kSide) continue;
        const bool cell = own != kSide - 1 && row != kSide - 1 && drawn && ((which >> grid) & 1u) != 0;
        Vertex& v = grids[static_cast<std::size_t>(kFirst + grid * kPlace + row * kSide + own)];
        v = {0, static_cast<std::uint16_t>(cell ? (apart ? 7 : 3) : 0), at, kSide, row == 0};
      }
    }
  }
  return grids;
}

// The edges of a line's vertices, behind a sentinel.
std::vector<ActiveEdge> started(Grids& grids, int line, bool both_sides) {
  std::uint16_t first = 0;
  for (std::size_t i = grids.size() - 1; i-- > kFirst;) {
    if (first_centre(grids[i].at.y) != line) continue;
    grids[i].next = first;
    first = static_cast<std::uint16_t>(i);
  }
  std::vector<ActiveEdge> edges(100);
  ActiveEdge* const begin = &edges[1];
  const ActiveEdge* const last = edges.data() + edges.size();
  begin[-1].x = INT32_MIN;
  const ActiveEdge* const end = both_sides ? GridStart<Vertex, true>(grids.data(), line).start(first, begin, last)
                                           : GridStart<Vertex>(grids.data(), line).start(first, begin, last);
  EXPECT_NE(end, nullptr);
  for (const ActiveEdge* edge = begin; edge != end; ++edge) EXPECT_GE(edge->x, edge[-1].x);
  return {begin, begin + (end - begin)};
}

using Covers = std::map<std::pair<int, std::int32_t>, CoverKey>;  // by line and column, what begins less what ends

// Adds what a grid's edges do; returns how many they are.
std::size_t add(Grids grids, bool both_sides, Covers& covers) {
  std::size_t count = 0;
  for (int line = -10; line < kLines; ++line) {
    for (ActiveEdge edge : started(grids, line, both_sides)) {
      ++count;
      EXPECT_EQ(edge.rest & ActiveEdge::kTall, 0u);
      for (int at = line;; ++at, edge.x += edge.dx, edge.rest -= ActiveEdge::kOneLine) {
        covers[{at, edge.column()}] += edge.toggle;
        if (edge.rest < ActiveEdge::kOneLine) break;
      }
    }
  }
  std::erase_if(covers, [](const auto& entry) { return entry.second == 0; });
  return count;
}

class GridStarts : public testing::TestWithParam<bool> {};

TEST_P(GridStarts, AJointIsOneEdgeAndCoversWhatItsHalvesDo) {
  const bool both_sides = GetParam();
  std::size_t joints = 0;
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    const Random random(seed);
    Covers apart, together;
    const std::size_t halves =
        add(make_grids(random, 1), both_sides, apart) + add(make_grids(random, 2), both_sides, apart);
    const std::size_t all = add(make_grids(random, 3), both_sides, together);
    ASSERT_EQ(apart, together) << "seed " << seed;
    ASSERT_LE(all, halves);
    joints += halves - all;
  }
  EXPECT_GT(joints, 300u);
}
INSTANTIATE_TEST_SUITE_P(Sides, GridStarts, testing::Bool());

}  // namespace
}  // namespace spanline::test
