#include "assetc/compile.hpp"

#include <gtest/gtest.h>

#include "assetc/scene_json.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline::host {
namespace {

double value(Fx16 v) { return std::ldexp(v.raw, -16); }

// Where the records put vertex `index` of instance `which`, in the scene's own units.
Vec3 placed(const CompiledScene& scene, std::size_t which, std::size_t index) {
  const InstanceRecord& instance = scene.instances()[which];
  const MeshTables& mesh = scene.meshes()[instance.mesh];
  const double unit = std::ldexp(mesh.unit, -31);
  const Position& p = mesh.positions[index];
  const Vec3 local = Vec3{value(mesh.origin[0]), value(mesh.origin[1]), value(mesh.origin[2])} +
                     unit * Vec3{double(p.x), double(p.y), double(p.z)};
  const Transform& t = instance.transform;
  Vec3 out;
  double* const sum[3] = {&out.x, &out.y, &out.z};
  for (int row = 0; row < 3; ++row) {
    *sum[row] = value(t.matrix[row][0]) * local.x + value(t.matrix[row][1]) * local.y +
                value(t.matrix[row][2]) * local.z + value(t.translation[row]);
  }
  return (1 / scene.fit().scale) * out + scene.fit().centre;
}

TEST(Compile, PutsVerticesWhereTheSceneHasThem) {
  for (const char* placement : {"", R"(,"translate":[100,0,0])", R"(,"rotate":[10,20,30],"scale":[1,2,0.1])",
                                R"(,"translate":[1e6,1e6,0])", R"(,"scale":1e-5)", R"(,"scale":1e5)"}) {
    const CompiledScene scene = compile(parse_scene(
        "s",
        std::string(R"({"meshes":[{"name":"m","obj":"good/cube.obj"}],"instances":[{"mesh":"m")") + placement + "}]}"));
    const ObjMesh obj = read_obj("good/cube.obj");
    const Placement place = scene.description().instances[0].placement(0);
    // Vertices are numbered in the order of first use by the corners.
    const double reach = std::max(largest(scene.bounds().centre - scene.fit().centre), scene.bounds().radius);
    const Vec3 wanted = place(obj.positions[static_cast<std::size_t>(obj.corners[0].position)]);
    EXPECT_LT(largest(placed(scene, 0, 0) - wanted), 1e-4 * reach) << placement;
  }
}

TEST(Compile, FillsTheWorld) {
  const CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::flat));
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, std::fabs(value(scene.camera().eye[i])));
  EXPECT_GT(most, 0.9 * kMaxWorld);
  EXPECT_LT(most, kMaxWorld);
  EXPECT_GE(value(scene.camera().near_plane), 2);
}

TEST(Compile, SharesGroupsBetweenLikeFaces) {
  const CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::flat));
  const std::vector<FaceGroup>& groups = scene.meshes()[0].groups;
  ASSERT_EQ(groups.size(), 2u);  // one blue face, five red ones
  EXPECT_EQ(groups[0].face_count, 1);
  EXPECT_EQ(groups[1].first_face, 1);
  EXPECT_EQ(groups[1].face_count, 5);
  EXPECT_EQ(groups[1].first_corner, 4u);
}

TEST(Compile, SplitsVerticesOnlyForGouraud) {
  EXPECT_EQ(compile(describe_obj("good/cube.obj", MeshShading::flat)).meshes()[0].positions.size(), 8u);
  EXPECT_TRUE(compile(describe_obj("good/cube.obj", MeshShading::flat)).meshes()[0].vertex_normals.empty());
  // Two faces carry normals of their own: four corners of the front, four of another.
  const CompiledScene smooth = compile(describe_obj("good/cube.obj", MeshShading::gouraud));
  EXPECT_GT(smooth.meshes()[0].positions.size(), 8u);
  EXPECT_EQ(smooth.meshes()[0].vertex_normals.size(), smooth.meshes()[0].positions.size());
}

TEST(Compile, MakesNormalsWhereTheFileHasNone) {
  const CompiledScene scene = compile(
      parse_scene("s", R"({"materials":[{"name":"a","color":[9,9,9],"shading":"gouraud"}],"meshes":[{"name":"m",)"
                       R"("material":"a","vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],)"
                       R"("faces":[[0,2,1],[0,1,3],[0,3,2]]}],"instances":[{"mesh":"m"}]})"));
  // Vertex 0 of three equal faces of a corner: along (-1, -1, -1).
  const Normal10 normal = scene.meshes()[0].vertex_normals[0];
  EXPECT_EQ(normal.x(), -295);
  EXPECT_EQ(normal.y(), -295);
  EXPECT_EQ(normal.z(), -295);
}

TEST(Compile, GivesFacesWithoutAreaTheirNumber) {
  const CompiledScene scene =
      compile(parse_scene("s", R"({"meshes":[{"name":"m","vertices":[[0,0,0],[1,0,0],[2,0,0],[0,1,0]],)"
                               R"("faces":[[0,1,2],[0,1,3]]}],"instances":[{"mesh":"m"}]})"));
  EXPECT_EQ(scene.meshes()[0].face_count, 2);
  const SceneRecord record = scene.record();
  SceneView view;
  EXPECT_TRUE(SceneView::validate(record, view).ok());
  EXPECT_EQ(view.face_count(), 2);
}

TEST(Compile, HoldsMovingThingsInTheWorld) {
  CompiledScene scene = compile(parse_scene(
      "s",
      R"({"meshes":[{"name":"m","obj":"good/cube.obj"}],"instances":[{"mesh":"m","motion":{"interpolation":"smooth",)"
      R"("keys":[{"frame":0},{"frame":10,"translate":[50,0,0],"rotate":[0,90,0],"scale":3},)"
      R"({"frame":20,"translate":[0,0,-80]}]}}]})"));
  for (std::int64_t frame = 0; frame <= 25; ++frame) {
    scene.show(frame);
    for (std::size_t i = 0; i < scene.meshes()[0].positions.size(); ++i) {
      const Vec3 p = scene.fit()(placed(scene, 0, i));
      EXPECT_LT(largest(p), kMaxWorld);
    }
  }
}

TEST(Compile, TakesScreenCoordinatesAsTheyAre) {
  const SceneDescription description = describe_screen_obj("good/screen.obj");
  const CompiledScene scene = compile(description);
  const Position& p = scene.meshes()[0].positions[0];
  EXPECT_EQ(p.x, -32768);
  EXPECT_EQ(p.y, 32767);
  EXPECT_EQ(p.z, 32767);
  EXPECT_EQ(scene.instances()[0].flags, InstanceRecord::kScreen);
}

}  // namespace
}  // namespace spanline::host
