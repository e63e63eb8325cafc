// How the sort's work grows with the polygons; docs/growth.md has the whole table, instructions too.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "bench/growth/scatter.hpp"
#include "core/area/window_sort.hpp"

namespace spanline::area::test {
namespace {

WindowCounts counts_of(std::uint32_t polygons, std::uint32_t most) {
  static const auto storage = std::make_unique<SortStorage<1200, 32000, 2000, 1>>();
  static const auto borders = std::make_unique<Pool<BorderEdge, 65000>>();
  static const auto nodes = std::make_unique<Pool<Node, 65000>>();
  static Pool<std::uint16_t, 9000> names;
  SortPools pools = storage->refs();
  pools.borders = borders->ref();
  pools.clipper.nodes = nodes->ref();
  AreaSort sort(pools);
  WindowSort<bench::Scatter> windows(sort, names.ref(), most);
  bench::CountPieces count;
  EXPECT_TRUE(windows.solve(bench::Scatter(polygons), bench::kGrowthScreen, count).ok());
  return windows.counts();
}

double power(std::uint32_t few, std::uint32_t many, double times) {
  return std::log(static_cast<double>(many) / few) / std::log(times);
}

TEST(Growth, WindowsMakeItNearlyLinear) {
  const WindowCounts few = counts_of(100, 16), many = counts_of(3000, 16);
  EXPECT_LT(power(few.sort.clips, many.sort.clips, 30), 1.2);
  EXPECT_LT(power(few.sort.pairs, many.sort.pairs, 30), 1.2);
  EXPECT_LT(power(few.window_tests, many.window_tests, 30), 1.35) << "n log n";
}

TEST(Growth, OneWindowIsQuadratic) {
  const WindowCounts few = counts_of(100, 0), many = counts_of(600, 0);
  ASSERT_EQ(many.windows, 1u);
  EXPECT_GT(power(few.sort.pairs, many.sort.pairs, 6), 1.9);
}

}  // namespace
}  // namespace spanline::area::test
