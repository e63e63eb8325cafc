// The edge walker against the segment walker: the same faces, depths and bytes in every pixel of random mesh scenes.
// SPANLINE_FULL=1 looks at more of them, SPANLINE_SEED=N at one.
#include <gtest/gtest.h>

#include "vsg/scale.hpp"
#include "walker/decisions.hpp"

namespace spanline::test {
namespace {

void expect_same(const Decisions& a, const Decisions& b, const char* what) {
  EXPECT_TRUE(a.faces == b.faces) << what << ": other faces";
  EXPECT_TRUE(a.depths == b.depths) << what << ": other depths";
  EXPECT_TRUE(a.bytes == b.bytes) << what << ": other bytes";
  EXPECT_TRUE(a.status.ok() && b.status.ok()) << what;
}

class Walkers : public testing::TestWithParam<int> {
 protected:
  template <typename Check>
  void for_each_scene(const Check& check) {
    const char* only = std::getenv("SPANLINE_SEED");
    const auto first = static_cast<std::uint64_t>(only != nullptr ? std::atoll(only) : GetParam());
    const std::uint64_t end = only != nullptr ? first + 1 : scene_count(2400, 40000);
    for (std::uint64_t seed = first; seed < end && !HasFailure(); seed += kShards) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      MeshScene scene = random_mesh_scene(seed);
      const SceneRecord record = scene.record();
      SceneView view;
      ASSERT_TRUE(SceneView::validate(record, view).ok());
      check(scene, view);
    }
  }
};

TEST_P(Walkers, DrawTheSamePicture) {
  int drawn = 0, tried = 0;
  for_each_scene([&](const MeshScene& scene, const SceneView& view) {
    Memory pools(scene.screen);
    const Decisions edges = draw<Walker::edges>(pools.memory.storage(), view, scene.camera);
    ++tried;
    if (!edges.drawn || !edges.status.ok()) return;
    ++drawn;
    expect_same(draw<Walker::segments>(pools.memory.storage(), view, scene.camera), edges, "edges");
  });
  EXPECT_GT(drawn, tried * 3 / 4) << "too few scenes that the edge walker draws";
}

TEST_P(Walkers, GoOnForEachOtherAtAnyLine) {
  for_each_scene([&](const MeshScene& scene, const SceneView& view) {
    Memory plenty(scene.screen), scarce(scene.screen, static_cast<std::uint16_t>(4 + view.face_count() / 4));
    const Decisions segments = draw<Walker::segments>(plenty.memory.storage(), view, scene.camera);
    const auto cut = static_cast<std::uint16_t>(1 + view.face_count() % scene.screen.height);
    expect_same(segments, draw<Walker::both>(plenty.memory.storage(), view, scene.camera, cut), "both, in two bands");
    FrameStorage storage = plenty.memory.storage();
    storage.mesh.walker.edges[0] = scarce.memory.storage().mesh.walker.edges[0];
    storage.mesh.walker.edges[1] = scarce.memory.storage().mesh.walker.edges[1];
    expect_same(segments, draw<Walker::both>(storage, view, scene.camera), "both, few edges");
  });
}

INSTANTIATE_TEST_SUITE_P(Shards, Walkers, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
