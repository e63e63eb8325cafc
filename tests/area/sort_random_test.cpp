// The area sort against its slow twin on seeded random scenes. SPANLINE_FULL=1 looks at all 5,000; a failure names its
// seed, and SPANLINE_SEED=N runs that seed alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "area/sorted.hpp"

namespace spanline::area::test {
namespace {

constexpr std::uint64_t kAll = 5000, kSlice = 400;

std::uint64_t scenes_to_look_at() { return std::getenv("SPANLINE_FULL") != nullptr ? kAll : kSlice; }

// Half a unit of the vertices' grid.
constexpr double kReach = 1.0;

// Whether a polygon, or a notch of it, is narrower than that at a place: such a sliver may fold into a line, which is
// no edge of the output any more.
bool narrow_at(const oracle::SortScene& scene, int source, AreaPoint p) {
  int near = 0;
  for (const oracle::SortPolygon& polygon : scene) {
    if (polygon.source != source) continue;
    for (const AreaRing& ring : polygon.region) {
      for (std::size_t i = 0; i < ring.size(); ++i) near += distance(p, ring[i], ring[(i + 1) % ring.size()]) <= kReach;
    }
  }
  return near > 1;
}

void look_at_pixels(const oracle::SortScene& scene, const VisiblePieces& pieces) {
  for (int line = 0; line < oracle::kSortLines; ++line) {
    for (int column = 0; column < oracle::kSortColumns; ++column) {
      const AreaPoint centre{oracle::kSortUnits * column + oracle::kSortUnits / 2,
                             oracle::kSortUnits * line + oracle::kSortUnits / 2};
      const int expected = oracle::seen_at(scene, centre);
      bool doubtful = false;
      const int seen = seen_at(pieces, centre, 0, doubtful);
      if (seen == expected) continue;
      seen_at(pieces, centre, kReach, doubtful);
      ASSERT_TRUE(doubtful || narrow_at(scene, expected, centre) || narrow_at(scene, seen, centre))
          << "pixel " << column << ", " << line << ": expected " << expected << ", seen " << seen;
    }
  }
}

void look_at(std::uint64_t seed) {
  const oracle::SortScene scene = oracle::random_sort_scene(seed);
  const Sorted sorted = sort(scene);
  ASSERT_TRUE(sorted.status.ok()) << sorted.status.where;
  ASSERT_EQ(flaw(sorted.pieces), "");
  look_at_pixels(scene, sorted.pieces);
}

// Every third polygon is a pane.
bool is_pane(std::uint16_t source) { return source % 3 == 0; }

// The panes before the opaque polygon seen at `p`, from front to back; and it, or kBackdrop.
std::pair<std::uint16_t, std::vector<std::uint16_t>> seen_through(const oracle::SortScene& scene, AreaPoint p) {
  std::vector<const oracle::SortPolygon*> all;
  for (const oracle::SortPolygon& polygon : scene) {
    bool on = false;
    if (oracle::covers(polygon.region, {2 * p.x, 2 * p.y}, on)) all.push_back(&polygon);
  }
  std::sort(all.begin(), all.end(), [&](const oracle::SortPolygon* a, const oracle::SortPolygon* b) {
    return a->value(p) != b->value(p) ? a->value(p) > b->value(p) : a->source < b->source;
  });
  std::vector<std::uint16_t> panes;
  for (const oracle::SortPolygon* polygon : all) {
    if (!is_pane(polygon->source)) return {polygon->source, panes};
    panes.push_back(polygon->source);
  }
  return {kBackdrop, panes};
}

bool near_some_edge(const oracle::SortScene& scene, const VisiblePieces& pieces, AreaPoint p) {
  bool doubtful = false;
  seen_at(pieces, p, kReach, doubtful);
  for (const oracle::SortPolygon& polygon : scene)
    doubtful |= is_pane(polygon.source) && narrow_at(scene, polygon.source, p);
  return doubtful;
}

TEST(AreaSort, RandomPanesAgreeWithTheirTwin) {
  for (std::uint64_t seed = 0; seed < scenes_to_look_at() / 3; ++seed) {
    const oracle::SortScene scene = oracle::random_sort_scene(seed);
    std::vector<std::uint16_t> panes;
    for (const oracle::SortPolygon& polygon : scene) {
      if (is_pane(polygon.source)) panes.push_back(polygon.source);
    }
    const Sorted sorted = sort(scene, panes);
    ASSERT_TRUE(sorted.status.ok()) << sorted.status.where << seed;
    ASSERT_EQ(flaw(sorted.pieces), "") << seed;
    for (int i = 0; i < oracle::kSortColumns * oracle::kSortLines; i += 7) {
      const AreaPoint centre{oracle::kSortUnits * (i % oracle::kSortColumns) + oracle::kSortUnits / 2,
                             oracle::kSortUnits * (i / oracle::kSortColumns) + oracle::kSortUnits / 2};
      const auto expected = seen_through(scene, centre);
      std::pair<std::uint16_t, std::vector<std::uint16_t>> seen{kBackdrop, {}};
      for (const VisiblePiece& piece : sorted.pieces) {
        bool on = false;
        if (!oracle::covers(piece.rings, {2 * centre.x, 2 * centre.y}, on)) continue;
        seen = {piece.source, piece.films};
      }
      ASSERT_TRUE(seen == expected || near_some_edge(scene, sorted.pieces, centre)) << seed << " pixel " << i;
    }
  }
}

TEST(AreaSort, RandomScenesAgreeWithTheirTwin) {
  if (const char* seed = std::getenv("SPANLINE_SEED")) return look_at(std::strtoull(seed, nullptr, 10));
  for (std::uint64_t seed = 0; seed < scenes_to_look_at(); ++seed) {
    SCOPED_TRACE(seed);
    look_at(seed);
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace spanline::area::test
