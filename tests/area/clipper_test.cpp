// The clipper's cases by name, its counts, its messages and its memory.
#include "core/area/clipper.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "area/solved.hpp"
#include "oracle/random_polygon.hpp"

namespace spanline::area::test {
namespace {

AreaRing box(std::int64_t left, std::int64_t low, std::int64_t right, std::int64_t high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

struct Want {
  std::int64_t inside, outside;  // areas
  std::size_t inside_count, outside_count, inside_holes, outside_holes;
};

std::size_t holes(const Polygons& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) count += polygon.holes.size();
  return count;
}

void expect(const AreaRegion& subject, const AreaRegion& clip, const Want& want) {
  const Solved solved = solve(subject, clip);
  ASSERT_TRUE(solved.status.ok());
  EXPECT_EQ(flaw(solved.inside, solved.outside), "");
  EXPECT_EQ(solved.broken_link, "");
  EXPECT_EQ(twice_area(solved.inside), 2 * want.inside);
  EXPECT_EQ(twice_area(solved.outside), 2 * want.outside);
  EXPECT_EQ(solved.inside.size(), want.inside_count);
  EXPECT_EQ(solved.outside.size(), want.outside_count);
  EXPECT_EQ(holes(solved.inside), want.inside_holes);
  EXPECT_EQ(holes(solved.outside), want.outside_holes);
}

TEST(Clipper, OneCornerOverTheOther) { expect({box(0, 0, 4, 4)}, {box(2, 2, 6, 6)}, {4, 12, 1, 1, 0, 0}); }
TEST(Clipper, ABarAcross) { expect({box(0, 0, 6, 6)}, {box(2, -1, 4, 7)}, {12, 24, 1, 2, 0, 0}); }
TEST(Clipper, TheClipPolygonCutsAHole) { expect({box(0, 0, 9, 9)}, {box(3, 3, 6, 6)}, {9, 72, 1, 1, 0, 1}); }
TEST(Clipper, TheSubjectInsideTheClipPolygon) { expect({box(3, 3, 6, 6)}, {box(0, 0, 9, 9)}, {9, 0, 1, 0, 0, 0}); }
TEST(Clipper, Apart) { expect({box(0, 0, 2, 2)}, {box(3, 0, 5, 2)}, {0, 4, 0, 1, 0, 0}); }
TEST(Clipper, Identical) { expect({box(0, 0, 5, 5)}, {box(0, 0, 5, 5)}, {25, 0, 1, 0, 0, 0}); }
TEST(Clipper, IdenticalReversed) { expect({box(0, 0, 5, 5)}, {{{0, 0}, {0, 5}, {5, 5}, {5, 0}}}, {25, 0, 1, 0, 0, 0}); }
TEST(Clipper, NeighboursWithACommonEdge) { expect({box(0, 0, 4, 4)}, {box(4, 0, 8, 4)}, {0, 16, 0, 1, 0, 0}); }
TEST(Clipper, AnEdgeInsideAnother) { expect({box(0, 0, 8, 8)}, {box(2, 0, 6, 3)}, {12, 52, 1, 1, 0, 0}); }
TEST(Clipper, CornersTouch) { expect({box(0, 0, 4, 4)}, {box(4, 4, 8, 8)}, {0, 16, 0, 1, 0, 0}); }
TEST(Clipper, AVertexOnAnEdge) { expect({box(0, 0, 8, 8)}, {{{8, 4}, {4, 2}, {4, 6}}}, {8, 56, 1, 1, 0, 1}); }
TEST(Clipper, TheSubjectsHoleStays) {
  expect({box(0, 0, 9, 9), box(3, 3, 6, 6)}, {box(-1, -1, 10, 10)}, {72, 0, 1, 0, 1, 0});
}
TEST(Clipper, AnIslandInAHole) {
  expect({box(0, 0, 20, 20), box(4, 4, 16, 16), box(8, 8, 12, 12)}, {box(0, 0, 20, 10)}, {136, 136, 2, 2, 0, 0});
}
TEST(Clipper, TheClipPolygonsHoleIsOutside) {
  expect({box(0, 0, 9, 9)}, {box(-1, -1, 10, 10), box(3, 3, 6, 6)}, {72, 9, 1, 1, 1, 0});
}
TEST(Clipper, TouchingHolesStayApart) {
  expect({box(0, 0, 12, 12)}, {box(2, 2, 6, 6), box(6, 6, 10, 10)}, {32, 112, 2, 1, 0, 2});
}
TEST(Clipper, ARingOfTouchingHolesFreesAnIsland) {
  // Four boxes, corner to corner around the middle.
  expect({box(0, 0, 20, 20)}, {box(4, 8, 8, 12), box(8, 12, 12, 16), box(12, 8, 16, 12), box(8, 4, 12, 8)},
         {4 * 16, 400 - 4 * 16, 4, 2, 0, 1});
}
TEST(Clipper, NestedHolesFindTheirParents) {
  expect({box(0, 0, 30, 30)}, {box(2, 2, 28, 28), box(4, 4, 14, 14), box(16, 4, 26, 14), box(6, 6, 12, 12)},
         {676 - 100 - 100 + 36, 900 - 512, 2, 3, 2, 2});
}
TEST(Clipper, ASelfCrossingSubjectIsResolved) {
  expect({{{0, 0}, {8, 8}, {8, 0}, {0, 8}}}, {box(0, 0, 4, 8)}, {16, 16, 1, 1, 0, 0});
}
TEST(Clipper, ADoubledBorderCancels) {
  expect({box(0, 0, 4, 4), box(0, 0, 4, 4), box(8, 0, 12, 4)}, {box(0, 0, 10, 4)}, {8, 8, 1, 1, 0, 0});
}
TEST(Clipper, NothingAgainstSomething) {
  expect({}, {box(0, 0, 4, 4)}, {0, 0, 0, 0, 0, 0});
  expect({box(0, 0, 4, 4)}, {}, {0, 16, 0, 1, 0, 0});
  expect({}, {}, {0, 0, 0, 0, 0, 0});
}

TEST(Clipper, UnionAndDifferenceFallOut) {
  const Solved both = solve({box(0, 0, 4, 4)}, {box(4, 0, 8, 4)}, Operation::unite);
  EXPECT_EQ(both.inside.size(), 1u);
  EXPECT_EQ(twice_area(both.inside), 2 * 32);
  const Solved apart = solve({box(0, 0, 4, 4)}, {box(2, 0, 8, 4)}, Operation::differ);
  EXPECT_EQ(twice_area(apart.inside), 2 * 8);
  EXPECT_EQ(twice_area(apart.outside), 2 * 16);
}

TEST(Clipper, ListsAreLinkedAtTaggedIntersections) {
  PoolStorage<20, 20, 30, 4> storage;
  Clipper clipper(storage.refs());
  clipper.clear();
  put(clipper, Role::subject, {box(0, 0, 4, 4)});
  put(clipper, Role::clip, {box(2, 2, 6, 6)});
  ASSERT_TRUE(clipper.clip().ok());
  int tagged = 0, linked = 0;
  HalfEdge h = clipper.first_edge(clipper.first_main(List::inside));
  const HalfEdge first = h;
  do {
    tagged += clipper.at_intersection(h);
    if (clipper.linked(h) != 0) {
      ++linked;
      EXPECT_EQ(clipper.borders(h), cover_of(Role::clip))
          << "only the clip polygon's border has the subject on both sides";
    }
    h = clipper.next_edge(h);
  } while (h != first);
  EXPECT_EQ(tagged, 2);
  EXPECT_EQ(linked, 2);
}

TEST(Clipper, CountsWhatItDropsAndMerges) {
  PoolStorage<20, 20, 30, 4> storage;
  Clipper clipper(storage.refs());
  clipper.clear();
  put(clipper, Role::subject, {{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 0}}});
  put(clipper, Role::subject, {{{0, 0}, {4, 4}, {8, 8}}, {{1, 1}, {2, 2}}, {{3, 3}}, {}});
  put(clipper, Role::clip, {box(0, 0, 9, 9)});
  ASSERT_TRUE(clipper.clip().ok());
  EXPECT_EQ(clipper.counts().merged_points, 3u);
  EXPECT_EQ(clipper.counts().dropped_contours, 4u);
  EXPECT_EQ(clipper.counts().segments, 7u);
}

TEST(Clipper, OutOfRangeIsRefusedByName) {
  PoolStorage<20, 20, 30, 4> storage;
  Clipper clipper(storage.refs());
  clipper.clear(7, 8);
  put(clipper, Role::clip, {{{0, 0}, {40000, 0}, {0, 9}}});
  const Status status = clipper.clip();
  EXPECT_EQ(status.code, Code::bad_argument);
  EXPECT_STREQ(status.where, "clip");
  EXPECT_STREQ(status.field, "x");
  EXPECT_EQ(status.index, 8u);
  EXPECT_EQ(status.needed, 40000u);
  EXPECT_EQ(clipper.first_main(List::inside), 0);
}

TEST(Clipper, AnyPoolTooSmallIsNamedAndNothingComesOut) {
  PoolStorage<60, 120, 240, 40> storage;
  const AreaRegion subject = {box(0, 0, 40, 40), box(4, 4, 36, 36), box(10, 10, 30, 30)};
  const AreaRegion clip = {{{20, -5}, {47, 21}, {19, 43}, {-3, 22}}, box(15, 15, 25, 25)};
  const auto attempt = [&](std::uint32_t segments, std::uint32_t nodes, std::uint32_t edges, std::uint32_t contours) {
    Pools pools = storage.refs();
    pools.segments.limit(segments);
    pools.nodes.limit(nodes);
    pools.edges.limit(edges);
    pools.contours.limit(contours);
    Clipper clipper(pools);
    clipper.clear(7, 8);
    put(clipper, Role::subject, subject);
    put(clipper, Role::clip, clip);
    clipper.clip();
    return read(clipper);
  };
  const ClipCounts enough = attempt(60, 120, 240, 40).counts;
  ASSERT_TRUE(attempt(enough.segments, 120, 240, enough.contours).status.ok());
  const auto refused = [](const Solved& solved, const char* pool) {
    EXPECT_EQ(solved.status.code, Code::pool_exhausted);
    EXPECT_STREQ(solved.status.where, pool);
    EXPECT_TRUE(solved.inside.empty() && solved.outside.empty());
    EXPECT_EQ(solved.status.index, std::string(solved.status.field) == "subject" ? 7u : 8u);
  };
  for (std::uint32_t i = 0; i < enough.segments; ++i) refused(attempt(i, 120, 240, 40), "segments");
  for (std::uint32_t i = 0; i < enough.nodes; ++i) refused(attempt(60, i, 240, 40), "nodes");
  for (std::uint32_t i = 0; i < enough.edges; ++i) refused(attempt(60, 120, i, 40), "edges");
  for (std::uint32_t i = 0; i < enough.contours; ++i) refused(attempt(60, 120, 240, i), "contours");
}

// A closed polygon of 64 corners with alternating radii.
struct Round64 {
  std::int64_t x, y, outer, inner;
  int turned;

  AreaRing ring() const {
    AreaRing ring;
    for (int i = 0; i < 64; ++i) {
      const oracle::Point p = oracle::circle_point((16 * i + turned) % 1024);
      const std::int64_t radius = i % 2 == 0 ? outer : inner;
      ring.push_back({x + p.x * radius / 16384, y + p.y * radius / 16384});
    }
    return ring;
  }
};

TEST(Clipper, TwoPolygonsOf64CornersWorkIn8KB) {
  using Small = PoolStorage<128, 264, 392, 80>;
  static_assert(sizeof(Small) <= 8192);
  Small storage;
  constexpr std::pair<Round64, Round64> kPairs[] = {
      {Round64{0, 0, 8000, 8000, 0}, Round64{0, 0, 8000, 8000, 8}},        // crosses 128 times
      {Round64{0, 0, 8000, 5000, 0}, Round64{0, 0, 8000, 5000, 16}},       // stars, a spike in every gap
      {Round64{0, 0, 8000, 5000, 0}, Round64{4000, 1000, 8000, 5000, 5}},  // stars beside one another
      {Round64{0, 0, 8000, 3000, 0}, Round64{0, 0, 5500, 5500, 0}},        // a gear and a disc
      {Round64{0, 0, 8000, 8000, 0}, Round64{0, 0, 8000, 8000, 0}},        // identical
  };
  for (const auto& [first, second] : kPairs) {
    const AreaRing subject = first.ring(), clip = second.ring();
    Clipper clipper(storage.refs());
    clipper.clear();
    put(clipper, Role::subject, {subject});
    put(clipper, Role::clip, {clip});
    EXPECT_TRUE(clipper.clip().ok()) << clipper.status().where << " " << clipper.status().needed;
    const Solved small = read(clipper);
    EXPECT_EQ(flaw(small.inside, small.outside), "");
    EXPECT_EQ(twice_area(small.inside), twice_area(solve({subject}, {clip}).inside));
  }
}

}  // namespace
}  // namespace spanline::area::test
