// Coherence guides the search and never decides a pixel: the bytes are the same for every band split, every pool size
// that holds one line and whatever earlier frames left in memory; where a line does not fit, the frame says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "oracle/random_camera_scene.hpp"
#include "oracle/random_scene.hpp"
#include "vsg/drawing.hpp"
#include "vsg/facets_of_core.hpp"
#include "vsg/scale.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

std::vector<std::uint16_t> random_cuts(Random& random) {
  std::vector<std::uint16_t> cuts;
  const int density = random.below(3);
  for (std::uint16_t line = 1; line < kRandomScreen.height; ++line) {
    if (random.percent(density == 0 ? 100 : density == 1 ? 30 : 4)) cuts.push_back(line);
  }
  return cuts;
}

class Invariance : public testing::TestWithParam<int> {
 protected:
  // check(seed, view, camera, random) for screen, self-crossing and camera scenes in turn.
  template <typename Check>
  void for_each_scene(const Check& check) {
    const std::uint64_t count = scene_count(300, 3000);
    for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < count && !HasFailure(); seed += kShards) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      oracle::CameraScene space = oracle::random_camera_scene(seed);
      oracle::SceneStore screen = oracle::screen_scene(oracle::random_screen_facets(seed), oracle::random_layout(seed));
      oracle::SceneStore crossed =
          oracle::screen_scene(oracle::random_crossed_facets(seed), oracle::random_layout(seed));
      Random random(seed);
      for (oracle::SceneStore* store : {&screen, &crossed, &space.scene}) {
        const SceneRecord record = store->record();
        SceneView view;
        ASSERT_TRUE(SceneView::validate(record, view).ok());
        check(view, store == &space.scene ? space.camera : oracle::plain_camera(), random);
      }
    }
  }

  Drawing whole(const SceneView& scene, const CameraRecord& camera, Comparator comparator = Comparator::plane) {
    Drawing drawing = drawer_.draw(scene, camera, {comparator, {}, {}, XSort::list});
    EXPECT_TRUE(drawing.status.ok()) << drawing.status.where;
    EXPECT_EQ(drawing.broken, "");
    return drawing;
  }

  Drawer drawer_;
};

void expect_same(const Drawing& expected, const Drawing& actual, const char* what) {
  EXPECT_EQ(actual.broken, "") << what;
  EXPECT_TRUE(actual.bytes == expected.bytes) << what << ": other bytes";
  EXPECT_TRUE(actual.faces.faces == expected.faces.faces) << what << ": other faces";
  EXPECT_TRUE(actual.depths == expected.depths) << what << ": other depths";
}

TEST_P(Invariance, AnyBandSplit) {
  for_each_scene([this](const SceneView& scene, const CameraRecord& camera, Random& random) {
    for (const Comparator comparator : {Comparator::plane, Comparator::midpoint}) {
      const Drawing expected = whole(scene, camera, comparator);
      const Drawing cut = drawer_.draw(scene, camera, {comparator, {}, random_cuts(random), XSort::list});
      EXPECT_TRUE(cut.status.ok()) << cut.status.where;
      expect_same(expected, cut, "cut");
    }
  });
}

TEST_P(Invariance, BothComparatorsAgree) {
  for_each_scene([this](const SceneView& scene, const CameraRecord& camera, Random&) {
    expect_same(whole(scene, camera, Comparator::plane), whole(scene, camera, Comparator::midpoint), "midpoint");
  });
}

TEST_P(Invariance, BucketsSortAsTheListDoes) {
  for_each_scene([this](const SceneView& scene, const CameraRecord& camera, Random& random) {
    Choices choices;
    choices.x_sort = XSort::buckets;
    choices.cuts = random_cuts(random);
    expect_same(whole(scene, camera), drawer_.draw(scene, camera, choices), "buckets");
  });
}

TEST_P(Invariance, HintsMayBeMissing) {
  for_each_scene([this](const SceneView& scene, const CameraRecord& camera, Random& random) {
    Choices choices{random.percent(50) ? Comparator::plane : Comparator::midpoint, {}, {}, XSort::list};
    choices.limits.samples = static_cast<std::uint32_t>(random.below(6));
    choices.limits.implied = static_cast<std::uint32_t>(random.below(3));
    choices.limits.vertices = static_cast<std::uint32_t>(random.below(20));
    const Drawing poor = drawer_.draw(scene, camera, choices);
    EXPECT_TRUE(poor.status.ok()) << poor.status.where;
    expect_same(whole(scene, camera), poor, "few hints");
  });
}

// A line's own need is what the pools held at most when every line was its own band.
TEST_P(Invariance, PoolsThatHoldOneLine) {
  for_each_scene([this](const SceneView& scene, const CameraRecord& camera, Random& random) {
    std::vector<std::uint16_t> every_line;
    for (std::uint16_t line = 1; line < kRandomScreen.height; ++line) every_line.push_back(line);
    const Drawing lines = drawer_.draw(scene, camera, {Comparator::plane, {}, every_line, XSort::list});
    ASSERT_TRUE(lines.status.ok());
    const auto at_least = [&random](std::uint32_t need) {
      return std::max(need, 1u) + static_cast<std::uint32_t>(random.percent(50) ? 0 : random.below(10));
    };
    Choices choices;
    choices.limits.facets = at_least(lines.statistics.max_facets);
    choices.limits.polygons = at_least(lines.statistics.max_polygons);
    choices.limits.edges = at_least(lines.statistics.max_edges);
    choices.limits.segments = at_least(lines.statistics.max_segments);
    const Drawing tight = drawer_.draw(scene, camera, choices);
    EXPECT_TRUE(tight.status.ok()) << tight.status.where << " line " << tight.status.line << ": needs "
                                   << tight.status.needed << " of " << tight.status.limit;
    expect_same(whole(scene, camera), tight, "tight pools");
  });
}

// The active list needs a place for every segment over one pixel; the oracle knows how many there are.
TEST_P(Invariance, AnActiveListThatHoldsOnePixel) {
  for_each_scene([this](const SceneView& scene, const CameraRecord& camera, Random&) {
    const oracle::Rendering truth =
        oracle::render(kRandomScreen.width, kRandomScreen.height, facets_of(scene, camera, kRandomScreen));
    std::size_t most = 1;
    for (int line = 0; line < truth.height(); ++line) {
      for (int column = 0; column < truth.width(); ++column) {
        most = std::max(most, truth.candidates(column, line).size());
      }
    }
    for (const Comparator comparator : {Comparator::plane, Comparator::midpoint}) {
      Choices choices{comparator, {}, {}, XSort::list};
      choices.limits.active = static_cast<std::uint32_t>(most);
      const Drawing tight = drawer_.draw(scene, camera, choices);
      EXPECT_TRUE(tight.status.ok()) << tight.status.where << " line " << tight.status.line << ": needs "
                                     << tight.status.needed << " of " << tight.status.limit;
      expect_same(whole(scene, camera), tight, "short active list");
    }
  });
}

TEST_P(Invariance, PoolsThatDoNotAreNamedAndTheNextFrameIsWhole) {
  int exhausted = 0, ok = 0;
  for_each_scene([&](const SceneView& scene, const CameraRecord& camera, Random& random) {
    const Drawing expected = whole(scene, camera);
    Choices choices;
    const auto scarce = [&random] {
      return static_cast<std::uint32_t>(random.percent(50) ? 1 + random.below(8) : 65535);
    };
    choices.limits.facets = scarce();
    choices.limits.polygons = scarce();
    choices.limits.edges = random.percent(30) ? 0 : scarce();
    choices.limits.segments = scarce();
    choices.limits.active = scarce();
    choices.cuts = random_cuts(random);
    const Drawing poor = drawer_.draw(scene, camera, choices);
    if (poor.status.ok()) {
      ++ok;
      expect_same(expected, poor, "scarce pools");
    } else {
      ++exhausted;
      EXPECT_EQ(poor.broken, "");
      EXPECT_EQ(poor.status.code, Code::pool_exhausted);
      const std::string_view pool = poor.status.where;
      EXPECT_TRUE(pool == "facets" || pool == "polygons" || pool == "edges" || pool == "segments" || pool == "active")
          << pool;
      EXPECT_LT(poor.status.line, kRandomScreen.height);
      EXPECT_GT(poor.status.needed, poor.status.limit);
    }
    expect_same(expected, whole(scene, camera), "the frame after");
  });
  if (!HasFailure()) {
    EXPECT_GT(exhausted, 10);
    EXPECT_GT(ok, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(Shards, Invariance, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
