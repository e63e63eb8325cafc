// Meshes drawn in bands, of which little is kept, look as those of which everything is: whatever there is room for.
#include <gtest/gtest.h>

#include "assetc/scene_json.hpp"
#include "oracle/random.hpp"
#include "vsg/scale.hpp"
#include "walker/band_memory.hpp"
#include "walker/decisions.hpp"

namespace spanline::test {
namespace {

constexpr FrameOptions kWhole{.taps = true, .walker = Walker::edges};
constexpr FrameOptions kBands{.taps = true, .walker = Walker::edges, .bands = true};

void expect_same(const Decisions& whole, const Decisions& bands) {
  EXPECT_EQ(whole.drawn, bands.drawn);
  EXPECT_EQ(whole.status.code, bands.status.code);
  // Whether more faces than the set holds are met on a line may hang on the order of edges in one column.
  EXPECT_STREQ(whole.status.where, bands.status.where);
  if (!whole.status.ok()) return;
  EXPECT_TRUE(whole.faces == bands.faces) << "other faces";
  EXPECT_TRUE(whole.depths == bands.depths) << "other depths";
  EXPECT_TRUE(whole.bytes == bands.bytes) << "other bytes";
}

class Bands : public testing::TestWithParam<int> {};

TEST_P(Bands, ShowWhatTheWholeFrameShows) {
  int drawn = 0;
  for (auto seed = static_cast<std::uint64_t>(GetParam()); seed < scene_count(1600, 40000) && !HasFailure();
       seed += kShards) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    MeshScene scene = random_mesh_scene(seed + 5000000);
    const SceneRecord record = scene.record();
    SceneView view;
    ASSERT_TRUE(SceneView::validate(record, view).ok());
    const bool gouraud = seed / kShards % 2 == 0;
    Memory plenty(scene.screen, 2000, gouraud);
    oracle::Random random(seed);
    const auto up_to = [&random](int most) { return static_cast<std::uint16_t>(random.below(most + 1)); };
    const auto mask = [&random](int bits) { return static_cast<std::uint16_t>((1 << random.below(bits + 1)) - 1); };
    BandMemory little(view, scene.screen,
                      {.vertices = random.percent(20) ? std::uint16_t{0} : up_to(130),
                       .lines = static_cast<std::uint16_t>(1 + up_to(scene.screen.height)),
                       .looks = static_cast<std::uint16_t>(gouraud ? 1 + up_to(63) : mask(6) | 1),
                       .tables = mask(2),
                       .planes = mask(4),
                       .gouraud = gouraud,
                       .points = up_to(static_cast<int>(2 * view.vertex_count())),
                       .instances = up_to(3)});
    const auto cut = static_cast<std::uint16_t>(1 + up_to(2 * scene.screen.height));
    const Decisions bands = draw_by<kBands>(little.storage, view, scene.camera, cut);
    Decisions whole = draw_by<kWhole>(plenty.memory.storage(), view, scene.camera, cut);
    // Vertices without a face may lie where they like.
    if (!whole.drawn && bands.drawn) whole = draw<Walker::segments>(plenty.memory.storage(), view, scene.camera);
    expect_same(whole, bands);
    drawn += whole.drawn && whole.status.ok();
  }
  EXPECT_GT(drawn, 50);
}

INSTANTIATE_TEST_SUITE_P(Shards, Bands, testing::Range(0, kShards));

// A background that differs from line to line is each line's own, behind flat faces and smooth ones.
template <Paint kPaint>
int expect_backgrounds(std::uint64_t seed) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  MeshScene scene = random_mesh_scene(seed + 6000000);
  scene.screen.format = PixelFormat::rgb565;
  SceneRecord record = scene.record();
  record.background = {{static_cast<std::uint8_t>(seed * 29), 8, 200}, {40, static_cast<std::uint8_t>(seed * 53), 0}};
  SceneView view;
  EXPECT_TRUE(SceneView::validate(record, view).ok());
  constexpr bool kSmooth = kPaint == Paint::smooth_words;
  Memory plenty(scene.screen, 2000, kSmooth);
  BandMemory little(view, scene.screen,
                    {.vertices = 40,
                     .lines = scene.screen.height,
                     .looks = static_cast<std::uint16_t>(seed % 2 == 0 ? 63 : 15),
                     .tables = kSmooth,
                     .planes = 7,
                     .gouraud = kSmooth});
  const Decisions whole = draw_by<FrameOptions{.walker = Walker::edges}>(plenty.memory.storage(), view, scene.camera);
  const Decisions bands = draw_by<FrameOptions{.walker = Walker::edges, .bands = true, .paint = kPaint}>(
      little.storage, view, scene.camera);
  if (!whole.drawn || !whole.status.ok() || !bands.status.ok()) return 0;
  EXPECT_TRUE(whole.bytes == bands.bytes) << "other bytes";
  return 1;
}

TEST(Bands, HaveTheBackgroundOfEachLine) {
  int drawn = 0;
  for (std::uint64_t seed = 0, end = scene_count(200, 4000); seed < end && !HasFailure(); ++seed) {
    drawn += expect_backgrounds<Paint::flat_words>(seed);
    drawn += expect_backgrounds<Paint::smooth_words>(seed);
  }
  EXPECT_GT(drawn, 50);
}

// The benchmark's scenes from next to no memory to enough for one band.
class BandSizes : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(BandSizes, MakeNoDifference) {
  const auto& [file, shading] = GetParam();
  host::SceneDescription description = host::read_scene(std::string(SPANLINE_ASSETS) + "/scenes/" + file + ".json");
  const bool gouraud = std::string(shading) == "gouraud";
  for (auto& material : description.materials)
    material.shading = gouraud ? host::Shading::kGouraud : host::Shading::kFlat;
  host::CompiledScene scene = host::compile(std::move(description));
  scene.triangulate();
  const SceneRecord record = scene.record();
  SceneView view;
  ASSERT_TRUE(SceneView::validate(record, view).ok());
  const Screen screen{320, 240};
  Memory plenty(screen, 2000, gouraud);
  const Decisions whole = draw_by<kWhole>(plenty.memory.storage(), view, scene.camera());
  ASSERT_TRUE(whole.status.ok());
  for (const std::uint16_t vertices : std::initializer_list<std::uint16_t>{0, 1, 7, 20, 40, 63, 80, 126, 400}) {
    for (const std::uint16_t lines : std::initializer_list<std::uint16_t>{1, 13, 240}) {
      SCOPED_TRACE(testing::Message() << vertices << " vertices, " << lines << " lines");
      BandMemory little(view, screen,
                        {.vertices = vertices,
                         .lines = lines,
                         .looks = 15,
                         .tables = 0,
                         .planes = 7,
                         .gouraud = gouraud,
                         .points = 8u * vertices});
      expect_same(whole, draw_by<kBands>(little.storage, view, scene.camera()));
    }
  }
  // Where an edge has no room the line is the one where the whole frame's had none.
  BandMemory few(view, screen, {.vertices = 40, .lines = 240, .looks = 15, .tables = 0, .planes = 7, .edges = 4});
  const Decisions cut = draw_by<kBands>(few.storage, view, scene.camera());
  EXPECT_EQ(cut.status.code, Code::pool_exhausted);
  EXPECT_STREQ(cut.status.where, "edges");
}

INSTANTIATE_TEST_SUITE_P(Scenes, BandSizes,
                         testing::Combine(testing::Values("S1", "S3", "S4"), testing::Values("flat", "gouraud")));

TEST(Bands, RefuseWhatTheyHaveNoRoomFor) {
  MeshScene scene = random_mesh_scene(1);
  const SceneRecord record = scene.record();
  SceneView view;
  ASSERT_TRUE(SceneView::validate(record, view).ok());
  BandMemory memory(view, scene.screen, {.vertices = 8, .lines = 8, .looks = 1, .tables = 0, .planes = 1});
  memory.storage.bands.keys.limit(view.vertex_count() - 1u);
  const Decisions refused = draw_by<kBands>(memory.storage, view, scene.camera);
  EXPECT_FALSE(refused.drawn);
  EXPECT_EQ(refused.status.code, Code::pool_exhausted);
  EXPECT_STREQ(refused.status.where, "vertices");
}

}  // namespace
}  // namespace spanline::test
