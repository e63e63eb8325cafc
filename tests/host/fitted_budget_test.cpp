#include "sim/fitted_budget.hpp"

#include <gtest/gtest.h>

#include "assetc/scene_json.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

CompiledScene teapot() { return compile(read_scene(std::string(SPANLINE_ASSETS) + "/scenes/S3.json")); }

Rendering render_in(const CompiledScene& scene, const PoolSizes& pools) {
  EngineOptions options;
  options.pools = pools;
  options.observe = true;
  Rendering rendering;
  const SceneRecord record = scene.record();
  EXPECT_TRUE(Engine::make(options)->render(validated(record, "teapot"), scene.camera(), rendering).ok());
  return rendering;
}

TEST(FittedBudget, DrawsTheFrameInOneBandAndDropsNoHint) {
  CompiledScene scene = teapot();
  const Budget budget = fitted_budget(scene, 0, 0);
  EXPECT_TRUE(budget.gouraud);
  EXPECT_EQ(budget.vertices, scene.meshes().front().positions.size());
  const Rendering ample = render_in(scene, {}), fitted = render_in(scene, pools_of(budget));
  EXPECT_TRUE(fitted.status.ok());
  EXPECT_EQ(fitted.picture.rgb, ample.picture.rgb);
  EXPECT_EQ(fitted.statistics.bands, 1u);
  EXPECT_EQ(fitted.statistics.samples_dropped, 0u);
  EXPECT_EQ(fitted.statistics.implied_dropped, 0u);
}

TEST(FittedBudget, IsTheLeast) {
  CompiledScene scene = teapot();
  const Budget budget = fitted_budget(scene, 0, 0);
  PoolSizes fewer_facets = pools_of(budget), fewer_segments = pools_of(budget), fewer_samples = pools_of(budget);
  --fewer_facets.facets;
  --fewer_segments.segments;
  --fewer_samples.samples;
  EXPECT_GT(render_in(scene, fewer_facets).statistics.bands, 1u);
  EXPECT_EQ(render_in(scene, fewer_segments).status.code, Code::pool_exhausted);
  EXPECT_GT(render_in(scene, fewer_samples).statistics.samples_dropped, 0u);
}

TEST(FittedBudget, HasRoomForLayers) {
  CompiledScene scene = compile(read_scene(std::string(SPANLINE_ASSETS) + "/demos/panes.json"));
  const Budget budget = fitted_budget(scene, 0, 0);
  EXPECT_GT(budget.layers, 0);
  const Rendering ample = render_in(scene, {}), fitted = render_in(scene, pools_of(budget));
  EXPECT_TRUE(fitted.status.ok());
  EXPECT_EQ(fitted.picture.rgb, ample.picture.rgb);
  EXPECT_NE(emit_budget(budget, "panes", "frame 0").find(".layers = " + std::to_string(budget.layers)),
            std::string::npos);
}

TEST(FittedBudget, CoversEveryFrameThatIsAskedFor) {
  CompiledScene scene = compile(read_scene(std::string(SPANLINE_ASSETS) + "/scenes/clockwork.json"));
  const Budget all = fitted_budget(scene, 0, 4);
  for (std::int64_t frame = 0; frame <= 4; ++frame) {
    const Budget one = fitted_budget(scene, frame, frame);
    EXPECT_LE(one.facets, all.facets);
    EXPECT_LE(one.segments, all.segments);
    EXPECT_LE(one.edges, all.edges);
  }
}

TEST(FittedBudget, KnowsWhatTheEdgeWalkerDraws) {
  CompiledScene scene = teapot();
  const std::optional<Budget> budget = fitted_edge_budget(scene, 0, 0);
  ASSERT_TRUE(budget);
  EXPECT_EQ(budget->walker, Walker::edges);
  EXPECT_EQ(budget->facets, 992);
  EXPECT_EQ(budget->vertices, scene.meshes().front().positions.size());
  EXPECT_EQ(budget->planes, 15);
  EXPECT_TRUE(budget->plain);
  EXPECT_NE(emit_budget(*budget, "tea", "frame 0").find(".plain = true};"), std::string::npos);
  CompiledScene cube = compile(read_scene(std::string(SPANLINE_ASSETS) + "/scenes/S1.json"));
  cube.triangulate();
  EXPECT_EQ(fitted_edge_budget(cube, 0, 0)->planes, 7);  // all six that are seen, which others could pierce
  CompiledScene gears = compile(read_scene(std::string(SPANLINE_ASSETS) + "/scenes/clockwork.json"));
  EXPECT_FALSE(fitted_edge_budget(gears, 0, 0));  // faces of many corners
}

TEST(FittedBudget, ShrinksToBandsWhereMemoryIsShort) {
  CompiledScene scene = teapot();
  const std::optional<Budget> fitted = fitted_edge_budget(scene, 0, 0);
  ASSERT_TRUE(fitted);
  const std::optional<Budget> same = shrunk_budget(scene, 0, 0, *fitted, 20000);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->band_vertices, 0);
  const std::optional<Budget> half = shrunk_budget(scene, 0, 0, *fitted, 4000);
  ASSERT_TRUE(half);
  EXPECT_GT(half->band_vertices, 20);
  EXPECT_LE(half->band_vertices, BandVertices::kMost);
  EXPECT_GT(half->looks, 15);
  const std::string text = emit_budget(*half, "lamp", "frame 0 of lamp");
  EXPECT_NE(text.find(".band_vertices = "), std::string::npos);
  EXPECT_FALSE(shrunk_budget(scene, 0, 0, *fitted, 1000));
}

TEST(FittedBudget, IsWrittenAsAHeader) {
  const Budget budget{.width = 64, .height = 48, .facets = 7, .gouraud = false};
  const std::string text = emit_budget(budget, "lamp", "frame 0 of lamp");
  EXPECT_NE(text.find("namespace lamp {"), std::string::npos);
  EXPECT_NE(
      text.find("inline constexpr spanline::Budget kBudget{\n    .width = 64,\n    .height = 48,\n    .facets = 7,"),
      std::string::npos);
  EXPECT_NE(text.find(".gouraud = false};"), std::string::npos);
}

}  // namespace
}  // namespace spanline::host
