// The engine against the oracle on seeded random scenes. SPANLINE_FULL=1 looks at all 20,000; a failure names its seed,
// and SPANLINE_SEED=N runs that seed alone.
#include <gtest/gtest.h>

#include <cstdlib>

#include "oracle/compare.hpp"
#include "oracle/random_camera_scene.hpp"
#include "oracle/random_scene.hpp"
#include "vsg/facets_of_core.hpp"
#include "vsg/scale.hpp"
#include "vsg/trial.hpp"

namespace spanline::test {
namespace {

constexpr int kEnough = 3;  // failing seeds of a shard before it gives up

class RandomScenes : public testing::TestWithParam<int> {
 protected:
  // check(seed, comparator) returns what is wrong.
  template <typename Check>
  void for_each_seed(std::uint64_t count, const Check& check) {
    int failures = 0;
    const char* only = std::getenv("SPANLINE_SEED");
    const std::uint64_t first = static_cast<std::uint64_t>(only != nullptr ? std::atoll(only) : GetParam());
    const std::uint64_t end = only != nullptr ? first + 1 : count;
    for (std::uint64_t seed = first; seed < end && failures < kEnough; seed += kShards) {
      for (const Comparator comparator : {Comparator::plane, Comparator::midpoint}) {
        const std::string wrong = check(seed, comparator);
        EXPECT_EQ(wrong, "") << "seed " << seed << (comparator == Comparator::plane ? ", plane" : ", midpoint");
        failures += !wrong.empty();
      }
    }
  }

  Drawer drawer_;
};

TEST_P(RandomScenes, OnTheScreen) {
  for_each_seed(scene_count(3000, 20000), [this](std::uint64_t seed, Comparator comparator) {
    return judge_on_screen(drawer_, oracle::random_screen_facets(seed), oracle::random_layout(seed),
                           {comparator, {}, {}, XSort::list}, oracle::kOneUnit);
  });
}

TEST_P(RandomScenes, TiesGoToTheLowerFaceExactly) {
  for_each_seed(scene_count(400, 4000), [this](std::uint64_t seed, Comparator comparator) {
    return judge_on_screen(drawer_, oracle::random_level_facets(seed), oracle::random_layout(seed),
                           {comparator, {}, {}, XSort::list}, 0);
  });
}

TEST_P(RandomScenes, BeforeACamera) {
  for_each_seed(scene_count(600, 6000), [this](std::uint64_t seed, Comparator comparator) -> std::string {
    oracle::CameraScene space = oracle::random_camera_scene(seed);
    const SceneRecord record = space.scene.record();
    SceneView scene;
    if (!SceneView::validate(record, scene).ok()) return "refused";
    const std::vector<oracle::Facet> facets = facets_of(scene, space.camera, kRandomScreen);
    return judge(drawer_, scene, space.camera, facets, {comparator, {}, {}, XSort::list}, oracle::kOneUnit);
  });
}

INSTANTIATE_TEST_SUITE_P(Shards, RandomScenes, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
