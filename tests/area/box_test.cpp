// Z subdivision, by overlay and with a backdrop plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "area/sorted.hpp"
#include "core/area/box_sort.hpp"

namespace spanline::area::test {
namespace {

class Store {
 public:
  explicit Store(const oracle::SortScene& scene) : scene_(scene) {}
  std::uint32_t count() const { return static_cast<std::uint32_t>(scene_.size()); }
  void put(std::uint16_t i, AreaSort& sort) const { test::put(sort, scene_[i]); }
  std::int32_t nearest(std::uint16_t i) const {
    std::int64_t nearest = 0;
    for (const AreaRing& ring : scene_[i].region) {
      for (const AreaPoint p : ring) nearest = std::max(nearest, scene_[i].value(p) >> kPlaneBits);
    }
    return static_cast<std::int32_t>(nearest);
  }

 private:
  const oracle::SortScene& scene_;
};

struct Boxed {
  Status status;
  SortCounts counts;
  std::uint32_t boxes;
  std::vector<VisiblePieces> layers;
};

struct Sink : Reading {
  std::vector<VisiblePieces>& layers;
  explicit Sink(std::vector<VisiblePieces>& to) : Reading{&to.emplace_back()}, layers(to) {}
  void begin_box() { pieces = &layers.emplace_back(); }
};

enum class Way { overlay, backdrop };

Boxed solve(const oracle::SortScene& scene, std::uint32_t most, Way way, std::uint16_t solution = 4000) {
  static const auto storage = std::make_unique<SortStorage<4000, 30000, 8000, 10>>();
  static const auto pieces = std::make_unique<Pool<SolvedPiece, 4000>>();
  static const auto borders = std::make_unique<Pool<BorderEdge, 30000>>();
  static Pool<std::int32_t, 1000> depths;
  BoxPools pools{depths.ref(), pieces->ref(), borders->ref()};
  pools.solution.limit(solution);
  AreaSort sort(storage->refs());
  BoxSort<Store> boxes(sort, pools, most);
  Boxed boxed;
  boxed.layers.reserve(1000);
  Sink sink(boxed.layers);
  const Box window{{0, 0}, {oracle::kSortColumns * oracle::kSortUnits, oracle::kSortLines * oracle::kSortUnits}};
  boxed.status =
      way == Way::overlay ? boxes.overlay(Store(scene), window, sink) : boxes.with_backdrop(Store(scene), window, sink);
  boxed.counts = boxes.counts();
  boxed.boxes = boxes.boxes();
  return boxed;
}

void expect_the_twins_picture(const oracle::SortScene& scene, const std::vector<VisiblePieces>& layers,
                              std::uint64_t seed) {
  for (int i = 0; i < oracle::kSortColumns * oracle::kSortLines; i += 5) {
    const AreaPoint centre{oracle::kSortUnits * (i % oracle::kSortColumns) + oracle::kSortUnits / 2,
                           oracle::kSortUnits * (i / oracle::kSortColumns) + oracle::kSortUnits / 2};
    int seen = -1;
    bool doubtful = false;
    for (const VisiblePieces& layer : layers) {
      if (const int here = seen_at(layer, centre, 0, doubtful); here >= 0) seen = here;
    }
    if (seen == oracle::seen_at(scene, centre)) continue;
    for (const VisiblePieces& layer : layers) seen_at(layer, centre, 2.5, doubtful);
    ASSERT_TRUE(doubtful) << seed << ": " << i;
  }
}

TEST(BoxSort, BothWaysMakeTheSamePicture) {
  std::uint32_t boxes = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const oracle::SortScene scene = oracle::random_sort_scene(seed);
    const Boxed overlaid = solve(scene, 4, Way::overlay), backed = solve(scene, 4, Way::backdrop);
    ASSERT_TRUE(overlaid.status.ok() && backed.status.ok()) << seed << backed.status.where;
    for (const VisiblePieces& layer : overlaid.layers) ASSERT_EQ(flaw(layer), "") << seed;
    expect_the_twins_picture(scene, overlaid.layers, seed);
    ASSERT_EQ(flaw(backed.layers[0]), "") << seed;
    expect_the_twins_picture(scene, backed.layers, seed);
    boxes += backed.boxes;
  }
  EXPECT_GT(boxes, 300u);
}

// The seed's case: screen-sized polygons parallel to the display, the worst for windows. From the back, so that the
// first sort is of no help, every box but the nearest is hidden whole.
TEST(BoxSort, ScreenSizedPolygonsCostLess) {
  oracle::SortScene scene;
  oracle::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const std::int64_t x = random.between(0, 700), y = random.between(0, 500);
    scene.push_back({static_cast<std::uint16_t>(i),
                     {{{x, y}, {x, y + 700}, {x + 800, y + 700}, {x + 800, y}}},
                     0,
                     0,
                     std::int64_t{1000 + 50 * i} << kPlaneBits});
  }
  const Boxed whole = solve(scene, 1000, Way::overlay), overlaid = solve(scene, 10, Way::overlay),
              backed = solve(scene, 10, Way::backdrop);
  ASSERT_TRUE(whole.status.ok() && overlaid.status.ok() && backed.status.ok());
  expect_the_twins_picture(scene, backed.layers, 0);
  RecordProperty("polygons_at_once", overlaid.counts.polygons);
  EXPECT_EQ(whole.counts.polygons, 100);
  EXPECT_LE(overlaid.counts.polygons, 10);
  EXPECT_LT(2 * overlaid.counts.borders, whole.counts.borders);
}

TEST(BoxSort, SaysWhichPoolIsTooSmall) {
  const Boxed boxed = solve(oracle::random_sort_scene(1), 4, Way::backdrop, 1);
  EXPECT_STREQ(boxed.status.where, "solution");
  EXPECT_TRUE(boxed.layers[0].empty());
}

}  // namespace
}  // namespace spanline::area::test
