// Convex solids as silhouettes: the picture stays, and fewer clips make it.
#include <gtest/gtest.h>

#include <memory>

#include "area/sorted.hpp"

namespace spanline::area::test {
namespace {

struct Corner {
  int x, y, z;
};

// Seen from (1, 1, 1): x runs down to the left, y to the right, z upwards.
struct Box3 {
  Corner low, high;
};

struct Solved3 {
  Status status;
  SortCounts counts;
  VisiblePieces pieces;
};

class Boxes {
 public:
  explicit Boxes(std::uint64_t seed, int side) {
    oracle::Random random(seed);
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        for (int z = 0; z < 2; ++z) {
          if (random.percent(30)) continue;
          const Corner at{kCell * x, kCell * y, kCell * z};
          const auto grown = [&] { return random.between(60, kCell); };
          boxes_.push_back({at, {at.x + grown(), at.y + grown(), at.z + grown()}});
        }
      }
    }
  }

  void add(const Box3& box) { boxes_.push_back(box); }

  Solved3 solve(bool consolidated) const {
    static const auto storage = std::make_unique<SortStorage<800, 20000, 4000, 10>>();
    AreaSort sort(storage->refs());
    sort.clear();
    std::uint16_t source = 0;
    for (const Box3& box : boxes_) {
      const auto& [a, b] = box;
      if (consolidated) sort.begin_group();
      face(sort, source++, {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}});
      face(sort, source++, {{a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}});
      face(sort, source++, {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}});
      if (consolidated) sort.end_group();
    }
    Solved3 solved;
    solved.status = sort.solve();
    solved.counts = sort.counts();
    solved.pieces = read(sort);
    return solved;
  }

 private:
  static constexpr int kCell = 128;

  static void face(AreaSort& sort, std::uint16_t source, const std::vector<Corner>& corners) {
    sort.begin_polygon(source);
    sort.begin_contour();
    for (const Corner& c : corners)
      sort.vertex(7 * (c.y - c.x), 8 * c.z - 4 * (c.x + c.y), 100000 + 64 * (c.x + c.y + c.z));
    sort.end_contour();
    sort.end_polygon();
  }

  std::vector<Box3> boxes_;
};

void expect_the_same_picture(const VisiblePieces& a, const VisiblePieces& b) {
  for (int x = -3000; x < 3000; x += 61) {
    for (int y = -3000; y < 3000; y += 67) {
      bool doubtful = false;
      if (seen_at(a, {x, y}, 0, doubtful) == seen_at(b, {x, y}, 0, doubtful)) continue;
      seen_at(a, {x, y}, 1.5, doubtful);
      ASSERT_TRUE(doubtful) << x << " " << y;
    }
  }
}

TEST(Consolidation, SolidsAsSilhouettesMakeTheSamePictureWithFewerClips) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Boxes boxes(seed, 3);
    const Solved3 each = boxes.solve(false), whole = boxes.solve(true);
    ASSERT_TRUE(each.status.ok() && whole.status.ok()) << whole.status.where;
    ASSERT_EQ(flaw(whole.pieces), "") << seed;
    expect_the_same_picture(each.pieces, whole.pieces);
    EXPECT_LT(2 * whole.counts.clips, each.counts.clips) << seed;
    EXPECT_LT(3 * whole.counts.pairs, each.counts.pairs) << seed;
    EXPECT_EQ(whole.counts.pierced, 0u);
  }
}

TEST(Consolidation, APiercedSolidIsSortedFaceByFace) {
  Boxes boxes(1, 2);
  boxes.add({{20, -100, 20}, {40, 400, 40}});
  const Solved3 each = boxes.solve(false), whole = boxes.solve(true);
  ASSERT_TRUE(each.status.ok() && whole.status.ok());
  EXPECT_GT(whole.counts.pierced, 0u);
  ASSERT_EQ(flaw(whole.pieces), "");
  expect_the_same_picture(each.pieces, whole.pieces);
}

// What docs/hidden.md says of 49 boxes.
TEST(Consolidation, SavesAThirdOfTheClipsOfManySolids) {
  const Boxes boxes(5, 6);
  const Solved3 each = boxes.solve(false), whole = boxes.solve(true);
  EXPECT_LT(10 * (whole.counts.clips + whole.counts.details), 7 * each.counts.clips);
  EXPECT_LT(7 * whole.counts.pairs, each.counts.pairs);
}

}  // namespace
}  // namespace spanline::area::test
