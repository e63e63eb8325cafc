// The area sort on scenes made by hand, and what holds of every scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "area/sorted.hpp"

namespace spanline::area::test {
namespace {

using oracle::SortPolygon;
using oracle::SortScene;

constexpr std::int64_t kOne = 1 << kPlaneBits;

AreaRing box(std::int64_t left, std::int64_t low, std::int64_t right, std::int64_t high) {
  return {{left, low}, {left, high}, {right, high}, {right, low}};
}

SortPolygon level(std::uint16_t source, AreaRing ring, std::int64_t depth) {
  return {source, {std::move(ring)}, 0, 0, depth * kOne};
}

std::int64_t area_of(const VisiblePieces& pieces, std::uint16_t source) {
  std::int64_t sum = 0;
  for (const VisiblePiece& piece : pieces) {
    if (piece.source == source) sum += twice_area(Polygons{piece.polygon});
  }
  return sum / 2;
}

TEST(AreaSort, TheFrontPolygonCutsAHoleIntoWhatLiesBehind) {
  const Sorted sorted = sort({level(4, box(0, 0, 100, 100), 10), level(7, box(20, 30, 60, 50), 20)});
  ASSERT_EQ(sorted.pieces.size(), 2u);
  EXPECT_EQ(area_of(sorted.pieces, 4), 9200);
  EXPECT_EQ(area_of(sorted.pieces, 7), 800);
  EXPECT_EQ(sorted.counts.clips, 1u);
  for (const VisiblePiece& piece : sorted.pieces) EXPECT_EQ(piece.polygon.holes.size(), piece.source == 4 ? 1u : 0u);
}

TEST(AreaSort, CornersThatRepeatAtTheStartSpanAPlaneAllTheSame) {
  const Sorted sorted = sort({{3, {{{0, 0}, {0, 0}, {0, 0}, {0, 100}, {100, 100}, {100, 0}}}, kOne, 0, 9 * kOne}});
  EXPECT_EQ(sorted.counts.dropped, 0u);
  EXPECT_EQ(area_of(sorted.pieces, 3), 10000);
  EXPECT_EQ(sorted.pieces.at(0).plane.along_x, kOne);
}

TEST(AreaSort, AnErrorOfTheFirstSortIsMendedByRecursion) {
  // Seed 2, Fig. 3: the large one comes nearest at its far end, the small one lies before it.
  const SortPolygon slope{0, {box(0, 0, 1000, 100)}, 100 * kOne, 0, 0};
  const Sorted sorted = sort({slope, level(1, box(100, 20, 200, 80), 50000)});
  EXPECT_EQ(area_of(sorted.pieces, 1), 6000);
  EXPECT_EQ(area_of(sorted.pieces, 0), 94000);
  EXPECT_EQ(sorted.counts.recursions, 1u);
  EXPECT_EQ(sorted.counts.pierced, 0u);
}

TEST(AreaSort, OnePolygonBothBeforeAndBehindAnother) {
  // Seed 2, Fig. 4a: a comb of two teeth, one over the bar and one under it.
  const SortPolygon comb{0,
                         {{{0, 0}, {0, 200}, {60, 200}, {60, 60}, {240, 60}, {240, 200}, {300, 200}, {300, 0}}},
                         10 * kOne,
                         0,
                         5000 * kOne};
  const SortPolygon bar{1, {box(-40, 100, 340, 150)}, -10 * kOne, 0, 8000 * kOne};
  const Sorted sorted = sort({comb, bar});
  EXPECT_EQ(sorted.counts.pierced, 0u);
  EXPECT_EQ(sorted.counts.cyclic, 1u);
  EXPECT_EQ(area_of(sorted.pieces, 0), 60 * 300 + 60 * 140 + 60 * 90);
  EXPECT_EQ(area_of(sorted.pieces, 1), 380 * 50 - 60 * 50);
}

TEST(AreaSort, PolygonsThatPierceEachOtherMeetInTheirLine) {
  const SortPolygon rising{0, {box(0, 0, 100, 40)}, 10 * kOne, 0, 0},
      falling{1, {box(0, 0, 100, 40)}, -10 * kOne, 0, 1000 * kOne};
  const Sorted sorted = sort({rising, falling});
  EXPECT_EQ(sorted.counts.pierced, 1u);
  EXPECT_EQ(area_of(sorted.pieces, 0), 2000);
  EXPECT_EQ(area_of(sorted.pieces, 1), 2000);
  bool doubtful = false;
  EXPECT_EQ(seen_at(sorted.pieces, {30, 20}, 0, doubtful), 1);
  EXPECT_EQ(seen_at(sorted.pieces, {70, 20}, 0, doubtful), 0);
}

TEST(AreaSort, EqualDepthsGoToTheLowerSource) {
  const Sorted sorted = sort({level(5, box(0, 0, 10, 10), 7), level(3, box(5, 0, 15, 10), 7)});
  EXPECT_EQ(area_of(sorted.pieces, 3), 100);
  EXPECT_EQ(area_of(sorted.pieces, 5), 50);
}

TEST(AreaSort, PanesAddUpFromFrontToBack) {
  const SortScene scene = {level(0, box(0, 0, 30, 10), 30), level(1, box(10, 0, 40, 10), 20),
                           level(2, box(20, 0, 50, 10), 10), level(3, box(0, 0, 25, 10), 5),
                           level(4, box(24, 0, 26, 10), 25)};
  const Sorted sorted = sort(scene, {0, 1, 2});
  using Films = std::vector<std::uint16_t>;
  const auto films_at = [&](std::int64_t x) {
    for (const VisiblePiece& piece : sorted.pieces) {
      bool on = false;
      if (oracle::covers(rings_of(Polygons{piece.polygon}), {2 * x + 1, 9}, on))
        return std::pair{piece.source, piece.films};
    }
    return std::pair{std::uint16_t{0}, Films{}};
  };
  EXPECT_EQ(films_at(5), (std::pair<std::uint16_t, Films>{3, {0}}));
  EXPECT_EQ(films_at(15), (std::pair<std::uint16_t, Films>{3, {0, 1}}));
  EXPECT_EQ(films_at(22), (std::pair<std::uint16_t, Films>{3, {0, 1, 2}}));
  EXPECT_EQ(films_at(24), (std::pair<std::uint16_t, Films>{4, {0}}));
  EXPECT_EQ(films_at(28), (std::pair<std::uint16_t, Films>{kBackdrop, {0, 1, 2}}));
  EXPECT_EQ(films_at(35), (std::pair<std::uint16_t, Films>{kBackdrop, {1, 2}}));
  EXPECT_EQ(films_at(45), (std::pair<std::uint16_t, Films>{kBackdrop, {2}}));
  EXPECT_EQ(films_at(55), (std::pair<std::uint16_t, Films>{0, {}}));
}

void put_detail(AreaSort& sort, std::uint16_t source, const AreaRing& ring) {
  sort.begin_detail(source);
  sort.begin_contour();
  for (const AreaPoint p : ring) sort.vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y), 0);
  sort.end_contour();
  sort.end_polygon();
}

// A die's face with two pips that overlap and one that reaches over its border, pierced by a blade and half under a
// lid.
TEST(AreaSort, SurfaceDetailIsSeenWhereItsPolygonIs) {
  const auto storage = std::make_unique<SortStorage<20, 500, 80, 10>>();
  AreaSort sort(storage->refs());
  sort.clear();
  put(sort, level(0, box(0, 0, 100, 100), 1000));
  put_detail(sort, 10, box(10, 10, 30, 30));
  put_detail(sort, 11, box(20, 20, 40, 40));
  put_detail(sort, 12, box(90, 40, 120, 60));
  put(sort, level(1, box(0, 60, 100, 100), 2000));
  put(sort, SortPolygon{2, {box(0, 0, 100, 50)}, 20 * kOne, 0, 700 * kOne});
  ASSERT_TRUE(sort.solve().ok());
  const VisiblePieces pieces = read(sort);
  EXPECT_EQ(flaw(pieces), "");
  EXPECT_EQ(sort.counts().pierced, 1u);
  EXPECT_EQ(sort.counts().clips, 3u) << "detail costs no clip of the sort";
  // The blade is in front right of x = 15.
  EXPECT_EQ(area_of(pieces, 10), 5 * 20);
  EXPECT_EQ(area_of(pieces, 11), 0);
  EXPECT_EQ(area_of(pieces, 12), 10 * 10);
  EXPECT_EQ(area_of(pieces, 1), 4000);
  EXPECT_EQ(area_of(pieces, 2), 85 * 50);
  EXPECT_EQ(area_of(pieces, 0), 6000 - 85 * 50 - 5 * 20 - 100);
}

TEST(AreaSort, TheHighestDetailLiesOnTop) {
  const auto storage = std::make_unique<SortStorage<20, 500, 80, 10>>();
  AreaSort sort(storage->refs());
  sort.clear({{0, 0}, {50, 50}});
  put(sort, level(0, box(60, 0, 100, 100), 1000));
  put_detail(sort, 9, box(70, 10, 80, 20));  // outside of the window, with its polygon
  put(sort, level(1, box(0, 0, 100, 100), 1000));
  put_detail(sort, 11, box(20, 20, 40, 40));
  put_detail(sort, 10, box(10, 10, 30, 30));
  ASSERT_TRUE(sort.solve().ok());
  const VisiblePieces pieces = read(sort);
  EXPECT_EQ(area_of(pieces, 9), 0);
  EXPECT_EQ(area_of(pieces, 10), 300);
  EXPECT_EQ(area_of(pieces, 11), 400);
  EXPECT_EQ(area_of(pieces, 1), 1800);
}

TEST(AreaSort, WhatLiesOutsideOfTheWindowIsCutAway) {
  const auto storage = std::make_unique<SortStorage<10, 200, 40, 10>>();
  AreaSort sort(storage->refs());
  sort.clear({{10, 10}, {20, 20}});
  put(sort, level(0, box(0, 0, 15, 15), 5));
  put(sort, level(1, box(30, 0, 40, 15), 5));
  ASSERT_TRUE(sort.solve().ok());
  const VisiblePieces pieces = read(sort);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(area_of(pieces, 0), 25);
}

TEST(AreaSort, TheOrderOfTheInputChangesNothing) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SortScene scene = oracle::random_sort_scene(seed);
    const AreaRegion before = rings_of(sort(scene).pieces);
    oracle::Random random(seed);
    for (std::size_t i = scene.size(); i > 1; --i) {
      std::swap(scene[i - 1], scene[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    for (SortPolygon& polygon : scene) {
      for (AreaRing& ring : polygon.region) std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    }
    ASSERT_EQ(rings_of(sort(scene).pieces), before) << seed;
  }
}

TEST(AreaSort, ASmallPoolIsNamedAndNothingIsLeftBehind) {
  const SortScene scene = oracle::random_sort_scene(3);
  const auto storage = std::make_unique<SortStorage<2000, 30000, 8000, 4000>>();
  std::vector<std::string> named;
  using Limit = std::function<void(SortPools&)>;
  const std::vector<Limit> limits = {[](SortPools& p) { p.polygons.limit(2); },
                                     [](SortPools& p) { p.borders.limit(20); },
                                     [](SortPools& p) { p.borders.limit(60); },
                                     [](SortPools& p) { p.pieces.limit(3); },
                                     [](SortPools& p) { p.films.limit(1); },
                                     [](SortPools& p) { p.frames.limit(2); },
                                     [](SortPools& p) { p.clipper.segments.limit(15); },
                                     [](SortPools& p) { p.clipper.nodes.limit(12); },
                                     [](SortPools& p) { p.clipper.edges.limit(4); },
                                     [](SortPools& p) { p.clipper.contours.limit(1); }};
  for (const Limit& limit : limits) {
    SortPools pools = storage->refs();
    limit(pools);
    AreaSort sort(pools);
    sort.clear();
    for (const SortPolygon& polygon : scene)
      put(sort, polygon, polygon.source % 2 == 0 ? Opacity::translucent : Opacity::opaque);
    const Status status = sort.solve();
    EXPECT_EQ(status.code, Code::pool_exhausted);
    EXPECT_STREQ(status.field, "polygon");
    EXPECT_TRUE(std::any_of(scene.begin(), scene.end(), [&](const SortPolygon& p) { return p.source == status.index; }))
        << status.where << " names " << status.index;
    EXPECT_EQ(status.needed, status.limit + 1) << status.where;
    EXPECT_TRUE(read(sort).empty());
    named.emplace_back(status.where);
  }
  const std::vector<std::string> expected = {"polygons", "borders",  "borders", "pieces", "films",
                                             "frames",   "segments", "nodes",   "edges",  "contours"};
  EXPECT_EQ(named, expected);
}

TEST(AreaSort, RefusesWhatIsOutOfRange) {
  const auto storage = std::make_unique<SortStorage<10, 200, 40, 10>>();
  AreaSort sort(storage->refs());
  const auto status_of = [&](std::int32_t x, std::int32_t y, std::int32_t depth) {
    sort.clear();
    put(sort, level(1, box(0, 0, 9, 9), 5));
    sort.begin_polygon(6);
    sort.begin_contour();
    sort.vertex(0, 0, 0);
    sort.vertex(x, y, depth);
    sort.vertex(0, 9, 0);
    sort.end_contour();
    sort.end_polygon();
    return sort.solve();
  };
  EXPECT_TRUE(status_of(9, 0, kMaxDepth).ok());
  EXPECT_STREQ(status_of(32768, 0, 0).field, "x");
  EXPECT_STREQ(status_of(0, -32768, 0).field, "y");
  EXPECT_STREQ(status_of(9, 0, -1).field, "depth");
  EXPECT_EQ(status_of(9, 0, kMaxDepth + 1).index, 6u);
  EXPECT_TRUE(read(sort).empty());
  EXPECT_TRUE(status_of(0, 5, 0).ok());
  EXPECT_EQ(sort.counts().dropped, 1u) << "a polygon without area";
}

}  // namespace
}  // namespace spanline::area::test
