// The loop that begins grids' edges, which some cores have in assembly, against the plain one, on the vertices that it
// is used for: grids of any kind that share sides, edges short and far, cells whose triangles are apart, room and none.
#include <gtest/gtest.h>

#include <cstring>

#include "core/frame/patch_grids.hpp"
#include "core/vsg/grid_start.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr int kMostSide = 3, kGrids = 2;  // vertices of a side
constexpr std::uint32_t kEntries = 1 + kGrids * (1 + kMostSide * kMostSide);
constexpr std::uint32_t kHeader = 1;  // a depth
constexpr int kMostEdges = 48;

// Boards have little memory. Behind the grids stand the points of rows, as wide as a row is.
GridVertex vertices[kEntries + 2 * kMostSide];
ActiveEdge fast[kMostEdges + 1], slow[kMostEdges + 1];

GridVertex vertex_of(ScreenXY at, std::uint32_t depth, std::uint32_t stride, bool first_row) {
  GridVertex v{};
  v.at = at;
  v.depth = depth & 0xffffffu;
  v.stride = stride & 0x7fu;
  v.first_row = first_row;
  return v;
}

// The grids' columns go on from one to the next, whose first is the last one's: joints. Returns their end.
std::uint32_t make_grids(Random& random) {
  std::memset(static_cast<void*>(vertices), 0, sizeof vertices);
  const int side = random.between(2, kMostSide), height = random.percent(30) ? 700 : random.percent(50) ? 150 : 25;
  const bool turned = random.percent(50), upside_down = random.percent(50);
  const int apart = random.percent(50) ? 0 : 30;
  ScreenXY points[kMostSide][kGrids * kMostSide];
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < kGrids * side; ++column) {
      const int x = height * column + random.between(-height, height) / 2;
      const int y = height * (upside_down ? -row : row) + random.between(-height, height) / 2;
      points[row][column] = {static_cast<std::int16_t>(turned ? y : x), static_cast<std::int16_t>(turned ? x : y)};
    }
  }
  std::uint32_t at = 1;
  for (int grid = 0; grid < kGrids; ++grid) {
    const auto stride = static_cast<std::uint32_t>(side);
    vertices[at++] = vertex_of({static_cast<std::int16_t>(side), 0}, kHeader, stride, false);
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column, ++at) {
        GridVertex& v = vertices[at];
        v = vertex_of(points[row][column + grid * (side - 1)], 0, stride, row == 0);
        const bool cell = row != side - 1 && column != side - 1 && random.percent(80);
        const unsigned parts = !cell                   ? 0u
                               : random.percent(apart) ? 4u + static_cast<unsigned>(random.between(1, 3))
                                                       : 3u;
        v.parts = parts & 7u;
      }
    }
  }
  return at;
}

// Any of the vertices above the line, in any order.
std::uint16_t make_list(Random& random, std::uint32_t end, std::int32_t line) {
  std::uint16_t first = 0;
  const bool backwards = random.percent(50);
  for (std::uint32_t i = 1; i != end; ++i) {
    const std::uint32_t v = backwards ? end - i : i;
    if (vertices[v].depth == kHeader || first_centre(vertices[v].at.y) > line || random.percent(20)) continue;
    vertices[v].next = first & 0x1fffu;
    first = static_cast<std::uint16_t>(v);
  }
  return first;
}

TEST(GridCells, BeginEdgesAsByThePlainLoop) {
  int begun = 0, joints = 0, stopped = 0;
  constexpr auto kRounds = oracle::rounds(200000u);
  for (std::uint64_t seed = 0; seed < kRounds; ++seed) {
    Random random(seed);
    const std::uint32_t end = make_grids(random);
    const int some = random.between(2, static_cast<int>(end) - 1);
    const std::int32_t line = first_centre(vertices[some].at.y) + random.below(3);
    const std::uint16_t first = make_list(random, end, line);
    const int room = random.percent(80) ? kMostEdges : random.below(16);
    fast[0].x = slow[0].x = INT32_MIN;
    const GridStart<GridVertex> start(vertices, line);
    const ActiveEdge* const at_fast = start.start(first, fast + 1, fast + 1 + room);
    const ActiveEdge* const at_slow = start.start_plain(first, slow + 1, slow + 1 + room);
    ASSERT_EQ(at_fast == nullptr, at_slow == nullptr) << "seed " << seed;
    if (at_slow == nullptr) {
      ++stopped;
      continue;
    }
    ASSERT_EQ(at_fast - fast, at_slow - slow) << "seed " << seed;
    const auto bytes = static_cast<std::size_t>(at_slow - slow - 1) * sizeof(ActiveEdge);
    ASSERT_EQ(std::memcmp(fast + 1, slow + 1, bytes), 0) << "seed " << seed;
    for (const ActiveEdge* edge = slow + 1; edge < at_slow; ++edge) {
      ASSERT_LE(edge[-1].x, edge->x) << "seed " << seed;
      ++begun;
      joints += edge->ending() != 0 && edge->beginning() != 0 &&
                (edge->ending() / 2u > end / 2) != (edge->beginning() / 2u > end / 2);
    }
  }
  EXPECT_GT(begun, static_cast<int>(kRounds));
  EXPECT_GT(joints, static_cast<int>(kRounds / 50));
  EXPECT_GT(stopped, static_cast<int>(kRounds / 100));
}

// GridVertex::put() writes words with these fields, and the assembly reads them.
TEST(GridCells, VerticesAreWordsWithTheirFieldsFromTheLowBitUp) {
  GridVertex v = vertex_of({-3, 5}, 0x812345, 0x55, true);
  v.color = 0x1234;
  v.next = 0x0fed;
  v.parts = 5;
  std::uint32_t words[3];
  std::memcpy(words, &v, sizeof words);
  EXPECT_EQ(words[0], 5u << 29 | 0x0fedu << 16 | 0x1234u);
  EXPECT_EQ(words[1], 0x0005fffdu);
  EXPECT_EQ(words[2], 1u << 31 | 0x55u << 24 | 0x812345u);
  EXPECT_EQ(words[2], GridVertex::InRow(0x55, true).word | 0x812345u);
}

}  // namespace
}  // namespace spanline::test
