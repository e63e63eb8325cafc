// Screen subdivision.
#include <gtest/gtest.h>

#include <memory>

#include "area/sorted.hpp"
#include "core/area/window_sort.hpp"

namespace spanline::area::test {
namespace {

class Store {
 public:
  explicit Store(const oracle::SortScene& scene) : scene_(scene) {}
  std::uint32_t count() const { return static_cast<std::uint32_t>(scene_.size()); }
  Box bounds(std::uint16_t i) const {
    Box box = Box::none();
    for (const AreaRing& ring : scene_[i].region) {
      for (const AreaPoint p : ring) box.widen({static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y)});
    }
    return box;
  }
  void put(std::uint16_t i, AreaSort& sort) const { test::put(sort, scene_[i]); }

 private:
  const oracle::SortScene& scene_;
};

constexpr Box kScreen{{0, 0}, {oracle::kSortColumns * oracle::kSortUnits, oracle::kSortLines* oracle::kSortUnits}};

struct Windowed {
  Status status;
  WindowCounts counts;
  VisiblePieces pieces;
};

Windowed sort_in_windows(const oracle::SortScene& scene, const SortPools& pools, std::uint32_t most,
                         std::uint16_t names = 4000) {
  static Pool<std::uint16_t, 4000> list;
  PoolRef<std::uint16_t> limited = list.ref();
  limited.limit(names);
  AreaSort sort(pools);
  WindowSort<Store> windows(sort, limited, most);
  Windowed solved;
  Reading sink{&solved.pieces};
  solved.status = windows.solve(Store(scene), kScreen, sink);
  solved.counts = windows.counts();
  return solved;
}

using Large = SortStorage<500, 8000, 2000, 100>;

void expect_the_twins_picture(const oracle::SortScene& scene, const VisiblePieces& pieces) {
  for (int i = 0; i < oracle::kSortColumns * oracle::kSortLines; i += 5) {
    const AreaPoint centre{oracle::kSortUnits * (i % oracle::kSortColumns) + oracle::kSortUnits / 2,
                           oracle::kSortUnits * (i / oracle::kSortColumns) + oracle::kSortUnits / 2};
    bool doubtful = false;
    if (seen_at(pieces, centre, 0, doubtful) == oracle::seen_at(scene, centre)) continue;
    seen_at(pieces, centre, 1.5, doubtful);
    ASSERT_TRUE(doubtful) << i;
  }
}

TEST(WindowSort, WindowsMakeTheSamePicture) {
  const auto storage = std::make_unique<Large>();
  std::uint32_t windows = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const oracle::SortScene scene = oracle::random_sort_scene(seed);
    const Windowed solved = sort_in_windows(scene, storage->refs(), 4);
    ASSERT_TRUE(solved.status.ok()) << solved.status.where << seed;
    ASSERT_EQ(flaw(solved.pieces), "") << seed;
    expect_the_twins_picture(scene, solved.pieces);
    windows += solved.counts.windows;
  }
  EXPECT_GT(windows, 1000u);
}

TEST(WindowSort, SmallPoolsCostTimeOnly) {
  const auto large = std::make_unique<Large>();
  const auto small = std::make_unique<SortStorage<16, 160, 60, 4>>();
  unsigned divided = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const oracle::SortScene scene = oracle::random_sort_scene(seed);
    const Windowed whole = sort_in_windows(scene, large->refs(), 0), parts = sort_in_windows(scene, small->refs(), 0);
    ASSERT_EQ(whole.counts.windows, 1u);
    if (!parts.status.ok()) continue;
    divided += parts.counts.windows > 1;
    ASSERT_EQ(flaw(parts.pieces), "") << seed;
    expect_the_twins_picture(scene, parts.pieces);
  }
  EXPECT_GT(divided, 20u);
}

TEST(WindowSort, SaysWhichPoolIsTooSmall) {
  const auto storage = std::make_unique<Large>();
  const oracle::SortScene scene = oracle::random_sort_scene(1);
  EXPECT_STREQ(sort_in_windows(scene, storage->refs(), 4, 2).status.where, "names");
  SortPools pools = storage->refs();
  pools.borders.limit(5);
  const Windowed solved = sort_in_windows(scene, pools, 4);
  EXPECT_STREQ(solved.status.where, "borders");
  EXPECT_EQ(flaw(solved.pieces), "") << "finished windows are whole";
}

}  // namespace
}  // namespace spanline::area::test
