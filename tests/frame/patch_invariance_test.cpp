// Patches: pools, bands and comparators change nothing that one sees.
#include <gtest/gtest.h>

#include "frame/patch_views.hpp"

namespace spanline::test {
namespace {

using host::EngineOptions;
using host::MeshShading;
using host::Rendering;
using oracle::Random;

// Pools that hold what one line needs of a random view, and little else.
EngineOptions frugal(Random& random) {
  EngineOptions options;
  options.comparator = random.percent(50) ? Comparator::midpoint : Comparator::plane;
  options.bands = static_cast<std::uint16_t>(random.percent(20) ? 240 : random.between(1, 30));
  options.pools.facets = static_cast<std::uint16_t>(random.between(500, 1500));
  options.pools.patch_facets = static_cast<std::uint16_t>(random.between(500, 1500));
  options.pools.patch_vertices = static_cast<std::uint16_t>(random.between(900, 2000));
  options.pools.edges = static_cast<std::uint16_t>(random.between(0, 40));
  options.pools.vertices = options.pools.samples = static_cast<std::uint16_t>(random.between(0, 20));
  options.pools.implied = 0;
  return options;
}

void expect_same(const host::CompiledScene& scene, const EngineOptions& options, int view) {
  const Rendering whole = render(scene, {}), parts = render(scene, options);
  ASSERT_TRUE(whole.status.ok());
  ASSERT_TRUE(parts.status.ok()) << "view " << view << ": " << parts.status.where << " needs " << parts.status.needed
                                 << " of " << parts.status.limit;
  EXPECT_EQ(whole.picture.rgb, parts.picture.rgb) << "view " << view;
  EXPECT_EQ(whole.ids, parts.ids) << "view " << view;
  EXPECT_EQ(whole.depth, parts.depth) << "view " << view;
}

void expect_same_in_views(host::CompiledScene scene, std::uint64_t seed, int views, double nearest) {
  Random random(seed);
  for (int view = 0; view < views && !testing::Test::HasFailure(); ++view) {
    look_from_anywhere(scene, random, nearest + random.below(100) / 100.0);
    expect_same(scene, frugal(random), view);
  }
}

TEST(PatchInvariance, TheTeapotFlat) { expect_same_in_views(teapot_scene(MeshShading::flat), 1, 12, 0.6); }
TEST(PatchInvariance, TheTeapotGouraud) { expect_same_in_views(teapot_scene(MeshShading::gouraud), 2, 12, 0.6); }

TEST(PatchInvariance, PatchesAmongMeshes) {
  // A row of cubes through the teapot, which stands twice, once mirrored and culled.
  expect_same_in_views(scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt"},{"name":"c","obj":"cubes.obj"}],)"
                                R"("instances":[{"mesh":"c"},{"mesh":"p"},{"mesh":"c","translate":[2,0.5,1.5]},)"
                                R"({"mesh":"p","translate":[0,1,0],"scale":[1,-0.8,1],"cull":true}]})"),
                       3, 8, 0.5);
}

TEST(PatchInvariance, ThroughTheNearPlane) { expect_same_in_views(teapot_scene(MeshShading::gouraud), 4, 6, 0.01); }

// In random views: the edge walker with pools that are large or little more than a line needs, and nothing to
// fall back on.
void expect_same_by_edges(host::CompiledScene scene, std::uint64_t seed, int views, int a_line = 600) {
  Random random(seed);
  for (int view = 0; view < views && !testing::Test::HasFailure(); ++view) {
    look_from_anywhere(scene, random, 0.6 + random.below(100) / 100.0);
    EngineOptions segments;
    segments.walker = Walker::segments;
    const Rendering by_segments = render(scene, segments);
    for (const int grid : {8191, static_cast<int>(random.between(a_line, 5 * a_line / 2))}) {
      EngineOptions edges;
      edges.walker = Walker::both;
      edges.pools.patch_grid = static_cast<std::uint16_t>(grid);
      edges.pools.facets = 0;
      if (grid != 8191) edges.pools.looks = static_cast<std::uint16_t>(random.between(1, 120));
      const Rendering by_edges = render(scene, edges);
      ASSERT_TRUE(by_edges.status.ok()) << "view " << view << ": " << by_edges.status.where << ", grid " << grid;
      EXPECT_EQ(by_segments.picture.rgb, by_edges.picture.rgb) << "view " << view << ", grid " << grid;
      EXPECT_EQ(by_segments.ids, by_edges.ids) << "view " << view;
      EXPECT_EQ(by_segments.depth, by_edges.depth) << "view " << view;
      EXPECT_EQ(by_segments.picture.rgb, render(scene, edges, false).picture.rgb) << "by the walk of boards";
    }
  }
}

TEST(PatchInvariance, TheEdgeWalkerDrawsTheSame) {
  expect_same_by_edges(
      scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt","shading":"flat"}],"instances":[{"mesh":"p","cull":true}],)"
               R"("lights":[{"direction":[0.4,-0.8,-0.5],"intensity":0.75}]})"),
      7, 30);
}

TEST(PatchInvariance, TheEdgeWalkerDrawsBothSidesTheSame) {
  expect_same_by_edges(
      scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt","shading":"flat"}],"instances":[{"mesh":"p"},)"
               R"({"mesh":"p","cull":true,"translate":[1,0.5,0.5]},)"
               R"({"mesh":"p","translate":[0,1,0.3],"scale":[1,-0.8,1]}],)"
               R"("lights":[{"direction":[0.4,-0.8,-0.5],"intensity":0.75}]})"),
      10, 30, 1600);
}

// Two patches that are nearly plane pierce each other: few cells, with edges that are begun more than once.
TEST(PatchInvariance, TheEdgeWalkerDrawsTallCellsFromBothSidesTheSame) {
  std::string vertices, patches[2];
  for (int i = 0; i < 32; ++i) {
    const int across = i % 4 * 10, along = i / 4 % 4 * 10, off = i % 5 == 0 ? 1 : 0;
    const int y = i < 16 ? along : 15 + off, z = i < 16 ? off : along - 15;
    vertices +=
        (i == 0 ? "[" : ",[") + std::to_string(across) + "," + std::to_string(y) + "," + std::to_string(z) + "]";
    patches[i / 16] += (i % 16 == 0 ? "" : ",") + std::to_string(i);
  }
  expect_same_by_edges(
      scene_of(
          R"({"materials":[{"name":"m","color":[200,90,50],"shading":"flat"}],"meshes":[{"name":"p","vertices":[)" +
          vertices + R"(],"patches":[[)" + patches[0] + "],[" + patches[1] +
          R"(]]}],"instances":[{"mesh":"p","material":"m"}],)"
          R"("lights":[{"direction":[0.4,-0.8,-0.5],"intensity":0.75}]})"),
      11, 60);
}

TEST(PatchInvariance, TheEdgeWalkerDrawsTheSameGouraud) {
  // One light and two materials; two lights, turned and stretched, and no ambient light, so that much of it is black.
  expect_same_by_edges(
      scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt","shading":"gouraud"}],"materials":[{"name":"g",)"
               R"("color":[40,200,90],"shading":"gouraud"}],"instances":[{"mesh":"p","cull":true},)"
               R"({"mesh":"p","material":"g","cull":true,"translate":[1,0.5,0.5],"rotate":[30,0,70]}],)"
               R"("lights":[{"direction":[0.4,-0.8,-0.5],"intensity":0.75}]})"),
      8, 15);
  expect_same_by_edges(
      scene_of(R"({"meshes":[{"name":"p","bpt":"teapot.bpt","shading":"gouraud"}],"ambient":0,)"
               R"("instances":[{"mesh":"p","cull":true,"scale":[1,0.6,1.3],"rotate":[10,20,30]}],)"
               R"("lights":[{"direction":[0.4,-0.8,-0.5],"intensity":0.9},{"direction":[-1,0.2,0],"intensity":0.4}]})"),
      9, 15);
}

TEST(PatchInvariance, OneLineThatDoesNotFitIsReported) {
  const host::CompiledScene scene = teapot_scene(MeshShading::flat);
  for (const char* pool : {"patch_facets", "patch_vertices", "facets"}) {
    EngineOptions options;
    *options.pools.find(pool) = 30;
    const Rendering out = render(scene, options);
    EXPECT_EQ(out.status.code, Code::pool_exhausted);
    EXPECT_STREQ(out.status.where, pool);
    EXPECT_EQ(out.status.limit, 30u);
    EXPECT_GT(out.status.needed, 30u);
    *options.pools.find(pool) = 2000;
    EXPECT_EQ(render(scene, options).picture.rgb, render(scene, {}).picture.rgb);
  }
}

}  // namespace
}  // namespace spanline::test
