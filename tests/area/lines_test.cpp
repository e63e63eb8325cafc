// Lines between visible pieces against their slow twin, which looks at every unit of every edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>

#include "area/sorted.hpp"
#include "core/area/line_drawing.hpp"

namespace spanline::area::test {
namespace {

struct DrawnLine {
  GridPoint from, to;
};

struct Collect {
  std::vector<DrawnLine> lines;
  void line(GridPoint from, GridPoint to) { lines.push_back({from, to}); }
};

// Put in as pieces of one look each.
struct Ring {
  std::uint16_t look;
  std::vector<GridPoint> points;
};

Status draw(const std::vector<Ring>& rings, std::uint16_t capacity, Collect& collect) {
  static Pool<DrawnEdge, 60000> edges;
  static Pool<GridPoint, 60000> points;
  PoolRef<DrawnEdge> some = edges.ref();
  some.limit(capacity);
  LineDrawing drawing(some, points.ref());
  drawing.clear();
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      drawing.edge(ring.points[i], ring.points[(i + 1) % ring.points.size()], ring.look);
    }
  }
  const Status status = drawing.solve();
  drawing.read(collect);
  return status;
}

TEST(LineDrawing, NeighboursShareALineAndPiecesOfOnePolygonHaveNone) {
  // Two pieces of one polygon, the right one cut at half height, and a neighbour of another below them.
  const std::vector<Ring> rings = {{5, {{0, 0}, {0, 10}, {10, 10}, {10, 5}, {10, 0}}},
                                   {5, {{10, 0}, {10, 10}, {20, 10}, {20, 0}}},
                                   {6, {{0, -10}, {0, 0}, {20, 0}, {20, -10}}}};
  Collect collect;
  EXPECT_TRUE(draw(rings, 100, collect).ok());
  std::int64_t length = 0;
  for (const DrawnLine& line : collect.lines) {
    EXPECT_FALSE(line.from.x == 10 && line.to.x == 10) << "a cut through one polygon";
    length += line.to.x - line.from.x + std::abs(line.to.y - line.from.y);
  }
  EXPECT_EQ(collect.lines.size(), 5u) << "left, right, top, bottom and between";
  EXPECT_EQ(length, 100);
}

TEST(LineDrawing, TooFewBlocksLeaveNoLines) {
  const std::vector<Ring> rings = {{5, {{0, 0}, {0, 10}, {10, 10}, {10, 0}}}};
  for (std::uint16_t capacity = 0; capacity < 4; ++capacity) {
    Collect collect;
    const Status status = draw(rings, capacity, collect);
    EXPECT_EQ(status.code, Code::pool_exhausted);
    EXPECT_STREQ(status.where, "lines");
    EXPECT_EQ(status.limit, capacity);
    EXPECT_TRUE(collect.lines.empty());
  }
}

// The parts of all lines, as they are cut at every corner: how often each is drawn.
using Parts = std::map<std::pair<GridPoint, GridPoint>, int>;

void add_parts(Parts& parts, const std::vector<GridPoint>& corners, GridPoint a, GridPoint b) {
  const GridPoint low = a < b ? a : b, high = a < b ? b : a;
  GridPoint last = low;
  for (const GridPoint& corner : corners) {
    if (!(low < corner) || !(corner < high) || orientation(low, high, corner) != 0) continue;
    ++parts[{last, corner}];
    last = corner;
  }
  ++parts[{last, high}];
}

TEST(LineDrawing, EveryBorderOfRandomScenesIsDrawnOnce) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Sorted sorted = sort(oracle::random_sort_scene(seed));
    ASSERT_TRUE(sorted.status.ok());
    std::vector<Ring> rings;
    std::vector<GridPoint> corners;
    for (const VisiblePiece& piece : sorted.pieces) {
      for (const AreaRing& ring : piece.rings) {
        Ring& made = rings.emplace_back(Ring{piece.source, {}});
        for (const AreaPoint& p : ring) {
          made.points.push_back({static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y)});
        }
        corners.insert(corners.end(), made.points.begin(), made.points.end());
      }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    // Of each part of an edge, whose it is: drawn unless two pieces of one polygon share it.
    std::map<std::uint16_t, Parts> of_look;
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        add_parts(of_look[ring.look], corners, ring.points[i], ring.points[(i + 1) % ring.points.size()]);
      }
    }
    Parts expected, drawn;
    for (const auto& [look, parts] : of_look) {
      for (const auto& [ends, times] : parts) {
        if (times == 1) expected[ends] = 1;
      }
    }
    Collect collect;
    ASSERT_TRUE(draw(rings, 60000, collect).ok());
    for (const DrawnLine& line : collect.lines) add_parts(drawn, corners, line.from, line.to);
    ASSERT_EQ(drawn, expected) << seed;
  }
}

}  // namespace
}  // namespace spanline::area::test
