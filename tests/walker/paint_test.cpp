// A frame of the edge walker that knows beforehand what it paints with draws what one does that asks its storage, and
// refuses what it has no code for.
#include <gtest/gtest.h>

#include "vsg/scale.hpp"
#include "walker/decisions.hpp"

namespace spanline::test {
namespace {

struct Drawn {
  Status status;
  std::vector<std::uint8_t> bytes;
};

template <Paint kPaint>
Drawn draw_with(const FrameStorage& storage, const SceneView& view, const CameraRecord& camera) {
  Frame<FrameOptions{.walker = Walker::edges, .paint = kPaint}> frame(storage);
  Drawn drawn;
  std::vector<std::uint32_t> words(frame.line_bytes() / 4 + 1);
  const Slice<std::uint8_t> line(reinterpret_cast<std::uint8_t*>(words.data()), frame.line_bytes());
  if (!frame.prepare(view, camera, {0, storage.screen.height}).empty()) {
    while (frame.next_line(line)) drawn.bytes.insert(drawn.bytes.end(), line.begin(), line.end());
  }
  drawn.status = frame.status();
  return drawn;
}

template <Paint kPaint>
void expect_as_any(const FrameStorage& storage, const SceneView& view, const CameraRecord& camera) {
  const Drawn fixed = draw_with<kPaint>(storage, view, camera), any = draw_with<Paint::any>(storage, view, camera);
  EXPECT_EQ(fixed.status.code, any.status.code);
  EXPECT_TRUE(fixed.bytes == any.bytes) << "other bytes";
}

MeshScene scene_of(std::uint64_t seed) {
  MeshScene scene = random_mesh_scene(seed + 2000000);
  scene.screen.format = PixelFormat::rgb565;
  return scene;
}

TEST(Paint, DecidedBeforehandGivesTheSamePicture) {
  for (std::uint64_t seed = 0, end = scene_count(400, 8000); seed < end && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    MeshScene scene = scene_of(seed);
    const SceneRecord record = scene.record();
    SceneView view;
    ASSERT_TRUE(SceneView::validate(record, view).ok());
    Memory flat(scene.screen, 2000, false), smooth(scene.screen);
    expect_as_any<Paint::flat_words>(flat.memory.storage(), view, scene.camera);
    expect_as_any<Paint::smooth_words>(smooth.memory.storage(), view, scene.camera);
  }
}

TEST(Paint, RefusesAnotherFormatAndStorageWithoutLooks) {
  MeshScene scene = scene_of(0);
  const SceneRecord record = scene.record();
  SceneView view;
  ASSERT_TRUE(SceneView::validate(record, view).ok());
  Memory flat(scene.screen, 2000, false);
  const Drawn without = draw_with<Paint::smooth_words>(flat.memory.storage(), view, scene.camera);
  EXPECT_EQ(without.status.code, Code::pool_exhausted);
  EXPECT_STREQ(without.status.where, "looks");
  EXPECT_TRUE(without.bytes.empty());
  Screen grey = scene.screen;
  grey.format = PixelFormat::grey8;
  Memory other(grey, 2000, false);
  const Drawn refused = draw_with<Paint::flat_words>(other.memory.storage(), view, scene.camera);
  EXPECT_EQ(refused.status.code, Code::bad_argument);
  EXPECT_STREQ(refused.status.where, "screen");
  EXPECT_TRUE(refused.bytes.empty());
}

}  // namespace
}  // namespace spanline::test
