// The edge walker against the oracle: the visible face of every pixel of random mesh scenes, and no span outside its
// face. SPANLINE_FULL=1 looks at more of them, SPANLINE_SEED=N at one.
#include <gtest/gtest.h>

#include "oracle/compare.hpp"
#include "vsg/facets_of_core.hpp"
#include "vsg/scale.hpp"
#include "walker/decisions.hpp"

namespace spanline::test {
namespace {

oracle::Picture picture_of(const Decisions& decisions, const Screen& screen) {
  oracle::Picture picture(screen.width, screen.height);
  std::transform(decisions.faces.begin(), decisions.faces.end(), picture.faces.begin(),
                 [](std::uint16_t face) { return face == kNoFace ? oracle::kNone : std::uint32_t{face}; });
  return picture;
}

// Counts pixels of spans, visible ones or not in the end, that their face does not cover.
struct Outside {
  const oracle::Rendering& truth;
  int pixels = 0;

  static void count(void* context, const VisibleSpan& span) {
    auto& outside = *static_cast<Outside*>(context);
    for (int column = span.left; span.face != kNoFace && column < span.right; ++column) {
      const auto& covering = outside.truth.candidates(column, span.line);
      outside.pixels += std::none_of(covering.begin(), covering.end(),
                                     [&](const oracle::Candidate& candidate) { return candidate.face == span.face; });
    }
  }
};

class EdgeWalkerAndOracle : public testing::TestWithParam<int> {
 protected:
  template <typename Check>
  void for_each_scene(std::uint64_t slice, std::uint64_t full, std::size_t copies, const Check& check) {
    const char* only = std::getenv("SPANLINE_SEED");
    const auto first = static_cast<std::uint64_t>(only != nullptr ? std::atoll(only) : GetParam());
    const std::uint64_t end = only != nullptr ? first + 1 : scene_count(slice, full);
    for (std::uint64_t seed = first; seed < end && !HasFailure(); seed += kShards) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      MeshScene scene = random_mesh_scene(seed + 1000000);
      scene.instances.insert(scene.instances.end(), copies, InstanceRecord{scene.instances.front()});
      const SceneRecord record = scene.record();
      SceneView view;
      ASSERT_TRUE(SceneView::validate(record, view).ok());
      check(scene, view,
            oracle::render(scene.screen.width, scene.screen.height, facets_of(view, scene.camera, scene.screen)));
    }
  }
};

TEST_P(EdgeWalkerAndOracle, AgreeOnEveryPixel) {
  int drawn = 0, tried = 0;
  for_each_scene(2400, 40000, 0, [&](const MeshScene& scene, const SceneView& view, const oracle::Rendering& truth) {
    Memory pools(scene.screen);
    const Decisions edges = draw<Walker::edges>(pools.memory.storage(), view, scene.camera);
    ++tried;
    if (!edges.drawn || !edges.status.ok()) return;
    ++drawn;
    const auto wrong = oracle::compare(picture_of(edges, scene.screen), truth);
    EXPECT_TRUE(wrong.empty()) << oracle::describe(wrong);
  });
  EXPECT_GT(drawn, tried * 3 / 4) << "too few scenes that the edge walker draws";
}

// Also on the line that it gives up because more faces cover a pixel than it can hold.
TEST_P(EdgeWalkerAndOracle, NoSpanLiesOutsideItsFace) {
  int given_up = 0;
  for_each_scene(800, 8000, 9, [&](const MeshScene& scene, const SceneView& view, const oracle::Rendering& truth) {
    Memory pools(scene.screen);
    Frame<FrameOptions{.taps = true, .walker = Walker::edges}> frame(pools.memory.storage());
    Outside outside{truth};
    frame.set_tap({&outside, Outside::count});
    std::vector<std::uint32_t> words(frame.line_bytes() / 4 + 1);
    const Slice<std::uint8_t> line(reinterpret_cast<std::uint8_t*>(words.data()), frame.line_bytes());
    if (frame.prepare(view, scene.camera, {0, scene.screen.height}).empty()) return;
    while (frame.next_line(line)) {
    }
    given_up += frame.status().code == Code::pool_exhausted;
    EXPECT_EQ(outside.pixels, 0);
  });
  EXPECT_GT(given_up, 3) << "too few scenes with lines that the edge walker gives up";
}

INSTANTIATE_TEST_SUITE_P(Shards, EdgeWalkerAndOracle, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
