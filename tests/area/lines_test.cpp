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

// The contours of pieces, each under the look that `look_of` gives its piece.
template <typename LookOf>
std::vector<Ring> rings_under(const VisiblePieces& pieces, LookOf look_of) {
  std::vector<Ring> rings;
  for (const VisiblePiece& piece : pieces) {
    for (const AreaRing& ring : piece.rings) {
      Ring& made = rings.emplace_back(Ring{look_of(piece), {}});
      for (const AreaPoint& p : ring) {
        made.points.push_back({static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y)});
      }
    }
  }
  return rings;
}

void add_corners(std::vector<GridPoint>& corners, const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) corners.insert(corners.end(), ring.points.begin(), ring.points.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

Parts drawn_parts(const std::vector<Ring>& rings, const std::vector<GridPoint>& corners) {
  Collect collect;
  EXPECT_TRUE(draw(rings, 60000, collect).ok());
  Parts drawn;
  for (const DrawnLine& line : collect.lines) add_parts(drawn, corners, line.from, line.to);
  return drawn;
}

TEST(LineDrawing, EveryBorderOfRandomScenesIsDrawnOnce) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Sorted sorted = sort(oracle::random_sort_scene(seed));
    ASSERT_TRUE(sorted.status.ok());
    const std::vector<Ring> rings = rings_under(sorted.pieces, [](const VisiblePiece& piece) { return piece.source; });
    std::vector<GridPoint> corners;
    add_corners(corners, rings);
    // Of each part of an edge, whose it is: drawn unless two pieces of one polygon share it.
    std::map<std::uint16_t, Parts> of_look;
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        add_parts(of_look[ring.look], corners, ring.points[i], ring.points[(i + 1) % ring.points.size()]);
      }
    }
    Parts expected;
    for (const auto& [look, parts] : of_look) {
      for (const auto& [ends, times] : parts) {
        if (times == 1) expected[ends] = 1;
      }
    }
    ASSERT_EQ(drawn_parts(rings, corners), expected) << seed;
  }
}

// Every third polygon is see-through. Pieces that overlap and name nobody have the same lines as those that tile the
// picture and name what they are seen through.
TEST(LineDrawing, WhatIsSeenThroughPanesHasItsLinesAndSoHaveThey) {
  const auto storage = std::make_unique<SortStorage<2000, 30000, 8000, 1>>();
  AreaSort unnamed(storage->refs(), Panes::unnamed);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const oracle::SortScene scene = oracle::random_sort_scene(seed);
    std::vector<std::uint16_t> panes;
    unnamed.clear();
    for (const oracle::SortPolygon& polygon : scene) {
      const bool pane = polygon.source % 3 == 0;
      if (pane) panes.push_back(polygon.source);
      put(unnamed, polygon, pane ? Opacity::translucent : Opacity::opaque);
    }
    ASSERT_TRUE(unnamed.solve().ok()) << unnamed.status().where;
    const Sorted named = sort(scene, panes);
    ASSERT_TRUE(named.status.ok());
    std::map<std::pair<std::uint16_t, std::vector<std::uint16_t>>, std::uint16_t> looks;
    const std::vector<Ring> tiles = rings_under(named.pieces, [&](const VisiblePiece& piece) {
      std::vector<std::uint16_t> films = piece.films;
      std::sort(films.begin(), films.end());
      const auto number = static_cast<std::uint16_t>(looks.size());
      return looks.try_emplace({piece.source, films}, number).first->second;
    });
    const std::vector<Ring> overlapping =
        rings_under(read(unnamed), [](const VisiblePiece& piece) { return piece.source; });
    std::vector<GridPoint> corners;
    add_corners(corners, tiles);
    add_corners(corners, overlapping);
    ASSERT_EQ(drawn_parts(overlapping, corners), drawn_parts(tiles, corners)) << seed;
  }
}

}  // namespace
}  // namespace spanline::area::test
