#include "assetc/patch_mesh.hpp"

#include <gtest/gtest.h>

#include "assetc/compile.hpp"
#include "assetc/emit_cpp.hpp"
#include "assetc/scene_json.hpp"
#include "host/support.hpp"
#include "sim/stats_json.hpp"

namespace spanline::host {
namespace {

const std::string kTeapot = std::string(SPANLINE_ASSETS) + "/teapot.bpt";

// A flat patch of 3 x 3 units in the x-y plane, inline; `more` goes into the instance.
std::string plate(const std::string& more = "") {
  std::string vertices, indices;
  for (int i = 0; i < 16; ++i) {
    const std::string comma = i == 0 ? "" : ",";
    vertices += comma + "[" + std::to_string(i % 4) + "," + std::to_string(i / 4) + ",0]";
    indices += comma + std::to_string(i);
  }
  return R"({"meshes":[{"name":"m","vertices":[)" + vertices + R"(],"patches":[[)" + indices +
         R"(]]}],"instances":[{"mesh":"m")" + more + "}]}";
}

TEST(PatchMesh, IsDrawnFromBothSidesUnlessTold) {
  EXPECT_FALSE(describe_bpt(kTeapot, MeshShading::automatic).instances[0].cull);
  EXPECT_FALSE(parse_scene("s", plate()).instances[0].cull);
  EXPECT_TRUE(parse_scene("s", plate(R"(,"cull":true)")).instances[0].cull);
}

TEST(PatchMesh, IsSmoothUnlessTold) {
  const auto shading = [](MeshShading wanted) { return describe_bpt(kTeapot, wanted).materials[0].shading; };
  EXPECT_EQ(shading(MeshShading::automatic), Shading::kGouraud);
  EXPECT_EQ(shading(MeshShading::flat), Shading::kFlat);
  EXPECT_EQ(shading(MeshShading::unlit), Shading::kUnlit);
}

TEST(PatchMesh, TheTeapotIsOneGroupInUnderFourKilobytes) {
  const CompiledScene scene = compile(describe_bpt(kTeapot, MeshShading::automatic));
  ASSERT_EQ(scene.meshes()[0].groups.size(), 1u);
  EXPECT_EQ(scene.meshes()[0].groups[0].contour_count, FaceGroup::kPatches);
  EXPECT_EQ(scene.meshes()[0].face_count, 32);
  EXPECT_LT(table_sizes(scene).total(), 4096u);
  SceneView view;
  const SceneRecord record = scene.record();
  EXPECT_TRUE(SceneView::validate(record, view).ok());
  EXPECT_TRUE(view.has_patches());
}

TEST(PatchMesh, MergingLeavesPatchesAlone) {
  CompiledScene scene = compile(parse_scene("s", plate()));
  scene.merge_coplanar(64);
  EXPECT_EQ(scene.meshes()[0].groups[0].contour_count, FaceGroup::kPatches);
  EXPECT_NE(emit_source(scene, "plate", "").find("{0, 0, 1, 16, 0, 0, 0}"), std::string::npos);
}

TEST(PatchMesh, CountsSidesOnce) {
  const SceneCounts counts = count_scene(describe_bpt(kTeapot, MeshShading::automatic));
  EXPECT_EQ(counts.polygons, 32u);
  EXPECT_EQ(counts.edges, 70u);
}

TEST(PatchMesh, RendersByTheToolWithOneNumberAPatch) {
  const TemporaryFolder folder;
  const ToolRun run = run_tool({"render", kTeapot, "--up", "0,0,1", "--eye", "5,-8,5", "--target", "0,0,1.5", "--ids",
                                folder.file("ids.ppm"), "--depth", folder.file("d.pgm"), "--stats", "-", "--bands", "7",
                                "--tolerance", "0.25"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* key : {"\"points_emitted\"", "\"distinct_pixels\"", "\"redundancy\"", "\"patch_facets\""}) {
    EXPECT_NE(run.out.find(key), std::string::npos) << key;
  }
  EXPECT_EQ(run_tool({"render", kTeapot, "--out", folder.file("o.ppm"), "--tolerance", "0"}).exit_code, 2);
}

}  // namespace
}  // namespace spanline::host
