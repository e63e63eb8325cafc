// The depth of a grid's face on a line, as GridChord has it, against the exact one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/pool.hpp"
#include "core/frame/patch_grids.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr std::uint32_t kCell = 2;  // its first vertex, behind what is none and the grid's header

using Vertices = PoolRef<GridVertex>;

// A cell of four corners round a place, in this order or turned; its triangles are apart where it is not convex.
void make_cell(Random& random, const Vertices& grid) {
  const int size = random.percent(30) ? 2000 : random.percent(50) ? 200 : 30;
  const int spread = random.percent(50) ? 300 << 8 : random.percent(50) ? 20 << 8 : 0x300000;
  const int x = random.between(-1000, 6000), y = random.between(0, 3000), z = random.between(spread, 0xffffff - spread);
  static constexpr int kAcross[4] = {-1, 1, 1, -1}, kDown[4] = {-1, -1, 1, 1};
  static constexpr std::uint32_t kPlace[4] = {0, 1, 3, 2};
  const int turn = random.below(4);
  ScreenXY at[4];
  for (int i = 0; i < 4; ++i) {
    const int from = (i + turn) % 4;
    at[i] = {static_cast<std::int16_t>(x + kAcross[from] * random.below(size)),
             static_cast<std::int16_t>(y + kDown[from] * random.below(size))};
    const auto depth = static_cast<std::uint32_t>(z + random.between(-spread, spread));
    GridVertex& vertex = grid[kCell + kPlace[i]];
    vertex = {};
    vertex.at = at[i];
    vertex.depth = depth & 0xffffffu;
    vertex.stride = 2;
    vertex.first_row = i < 2;
  }
  bool convex = true;
  for (int i = 0; i < 4; ++i) {
    const ScreenXY a = at[i], b = at[(i + 1) % 4], c = at[(i + 2) % 4];
    convex = convex && (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) > 0;
  }
  grid[kCell].parts = convex ? 3u : 7u;
}

struct ExactEdge {
  double x, depth;  // 28.4; in 1/65536, less half the range
};
ExactEdge on_line(const GridVertex& a, const GridVertex& b, int centre) {
  const double along = double(centre - a.at.y) / (b.at.y - a.at.y);
  return {a.at.x + along * (b.at.x - a.at.x), (a.depth + along * (double(b.depth) - a.depth)) / 256.0 - 32768.0};
}

TEST(GridChord, DepthIsThreeUnitsTooFarOffOrTwoTooNearAtMostButForItsSteepness) {
  Pool<GridVertex, kCell + 4> storage;
  const Vertices pool = storage.ref();
  const PatchGrids grids(pool, Screen{320, 240}, 8);
  int columns = 0, steep = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Random random(seed);
    make_cell(random, pool);
    const bool apart = pool[kCell].parts == 7u;
    const auto face = static_cast<FaceId>(2 * kCell + (apart && random.percent(50) ? 1u : 0u));
    const GridVertex* corner[4];
    const std::uint32_t count = grids.corners(face, corner);
    const std::int32_t line =
        first_centre(static_cast<std::int16_t>(corner[random.below(3)]->at.y + random.between(-40, 40)));
    const int centre = line * kSubpixels + kSubpixels / 2;
    ExactEdge edge[4];
    int edges = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const GridVertex &a = *corner[i], &b = *corner[(i + 1) % count];
      if ((a.at.y <= centre) != (b.at.y <= centre)) edge[edges++] = on_line(a, b, centre);
    }
    if (edges != 2) continue;
    if (edge[1].x < edge[0].x) std::swap(edge[0], edge[1]);
    const GridChord chord = grids.chord(face, line);
    const int first = static_cast<int>(std::ceil((edge[0].x - 8) / 16));
    const int end = static_cast<int>(std::ceil((edge[1].x - 8) / 16));
    for (const int column : {first, (first + end) / 2, end - 1}) {  // the ends of spans are anywhere between
      if (column < first || column >= end) continue;
      const double part = (column * 16 + 8 - edge[0].x) / (edge[1].x - edge[0].x);
      const double off = chord.depth_at(column) - (edge[0].depth + part * (edge[1].depth - edge[0].depth));
      ASSERT_LE(off, 2 + chord.steepness()) << "seed " << seed << " column " << column;
      ASSERT_GE(off, -3 - chord.steepness()) << "seed " << seed << " column " << column;
      ++columns;
      steep += chord.steepness() > 10;
    }
  }
  EXPECT_GT(columns, 20000);
  EXPECT_GT(steep, 1000);
}

}  // namespace
}  // namespace spanline::test
