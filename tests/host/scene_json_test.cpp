#include "assetc/scene_json.hpp"

#include <gtest/gtest.h>

#include "host/support.hpp"

namespace spanline::host {
namespace {

const std::string kMesh = R"("meshes":[{"name":"m","material":"red",)"
                          R"("vertices":[[0,0,0],[4,0,0],[4,4,0],[0,4,0],[1,1,0],[3,1,0],[2,3,0]],)"
                          R"("faces":[[[0,1,2,3],[4,6,5]],[0,2,1]]}],"materials":[{"name":"red","color":"#ff8000"}],)";
const std::string kInstance = R"("instances":[{"mesh":"m"}])";

TEST(SceneJson, HasTheDefaultsOfTheDocument) {
  const SceneDescription scene = parse_scene("s.json", "{" + kMesh + kInstance + "}");
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 240);
  EXPECT_FALSE(scene.camera.has_eye);
  EXPECT_EQ(scene.camera.fov, 45);
  EXPECT_FALSE(scene.lights.has_value());
  EXPECT_EQ(scene.ambient, (Vec3{0.25, 0.25, 0.25}));
  EXPECT_TRUE(scene.instances[0].cull);
}

TEST(SceneJson, ReadsRings) {
  const SceneDescription scene = parse_scene("s.json", "{" + kMesh + kInstance + "}");
  const MeshSource& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.faces.size(), 2u);
  EXPECT_EQ(mesh.faces[0].corner_count, 7u);
  EXPECT_EQ(mesh.faces[0].ring_count, 2u);
  EXPECT_EQ(mesh.rings, (std::vector<std::uint16_t>{4, 3}));
  EXPECT_EQ(mesh.faces[1].first_corner, 7u);
  EXPECT_EQ(scene.materials[0].color, (Color{255, 128, 0}));
}

TEST(SceneJson, ReadsLightsAndBackground) {
  const SceneDescription scene =
      parse_scene("s.json", "{" + kMesh + kInstance +
                                R"(,"lights":[{"direction":[0,-2,0],"intensity":[1,0.5,0]}],"ambient":[0.1,0.2,0.3],)"
                                R"("background":{"top":[1,2,3],"bottom":"#0a0b0c"}})");
  ASSERT_EQ(scene.lights->size(), 1u);
  EXPECT_EQ((*scene.lights)[0].intensity, (Vec3{1, 0.5, 0}));
  EXPECT_EQ(scene.ambient, (Vec3{0.1, 0.2, 0.3}));
  EXPECT_EQ(scene.background.top, (Color{1, 2, 3}));
  EXPECT_EQ(scene.background.bottom, (Color{10, 11, 12}));
}

TEST(SceneJson, ReadsSeeThroughMaterials) {
  const SceneDescription scene = parse_scene(
      "s.json", R"({"materials":[{"name":"a","color":[1,2,3],"opacity":0.4},)"
                R"({"name":"b","color":[1,2,3],"transmission":[1,0.2,0]},{"name":"red","color":[1,2,3]}],)" +
                    kMesh.substr(0, kMesh.find(R"("materials")")) + kInstance + "}");
  EXPECT_EQ(scene.materials[0].transmission, (Color{153, 153, 153}));
  EXPECT_EQ(scene.materials[1].transmission, (Color{255, 51, 0}));
  EXPECT_EQ(scene.materials[2].transmission, (Color{0, 0, 0}));
}

TEST(SceneJson, DetailComesAfterAllOtherFacesAndRunsAsItsParentDoes) {
  const std::string text =
      R"({"meshes":[{"name":"m","vertices":[[0,0,0],[4,0,0],[4,4,0],[0,4,0],[1,1,0],[3,1,0],[2,3,0]],)"
      R"("faces":[[0,1,2,3],[3,2,1,0]],"detail":[{"on":1,"faces":[[4,5,6]]},{"on":0,"faces":[[4,5,6],[[4,5,6],[6,5,4]]]}]}],)" +
      kInstance + "}";
  const SceneDescription scene = parse_scene("s.json", text);
  const MeshSource& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.faces.size(), 5u);
  EXPECT_EQ(mesh.parents, (std::vector<std::uint16_t>{1, 0, 0}));
  const auto corners = [&mesh](std::size_t face) {
    std::vector<std::int32_t> all;
    for (std::uint32_t i = 0; i < mesh.faces[face].corner_count; ++i) {
      all.push_back(mesh.corners[mesh.faces[face].first_corner + i].position);
    }
    return all;
  };
  EXPECT_EQ(corners(2), (std::vector<std::int32_t>{6, 5, 4}));
  EXPECT_EQ(corners(3), (std::vector<std::int32_t>{4, 5, 6}));
  EXPECT_EQ(corners(4), (std::vector<std::int32_t>{4, 5, 6, 6, 5, 4}));
}

TEST(SceneJson, FindsWhatTheDetailOfAnObjLiesOn) {
  const std::string text = R"({"meshes":[{"name":"m","obj":"good/pips.obj","detail":["red"]}],)" + kInstance + "}";
  const SceneDescription scene = parse_scene("s.json", text);
  const MeshSource& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.faces.size(), 4u);
  EXPECT_EQ(mesh.parents, (std::vector<std::uint16_t>{1, 0}));
  EXPECT_EQ(scene.materials[static_cast<std::size_t>(mesh.faces[0].material)].name, "glass");
  EXPECT_EQ(scene.materials[static_cast<std::size_t>(mesh.faces[0].material)].transmission, (Color{51, 25, 0}));
  EXPECT_EQ(scene.materials[static_cast<std::size_t>(mesh.faces[3].material)].name, "red");
}

TEST(SceneJson, NamesTheFileAndTheInnerFile) {
  const std::string text = R"({"meshes":[{"name":"m","obj":"broken/obj/one-vertex-face.obj"}],)" + kInstance + "}";
  EXPECT_EQ(message_of([&] { parse_scene("s.json", text); }),
            "s.json: /meshes/0/obj: broken/obj/one-vertex-face.obj:5: a face needs at least 3 vertices");
}

TEST(SceneJson, NamesThePathOfATwin) {
  EXPECT_EQ(message_of([&] { parse_scene("s.json", R"({"camera":{"fov":1,"fov":2}})"); }),
            "s.json: /camera: key 'fov' is written twice");
}

TEST(SceneJson, CountsLinesAndColumnsOfSyntaxErrors) {
  const std::string message = message_of([&] { parse_scene("s.json", "{\n  \"size\": [1,, 2]\n}"); });
  EXPECT_TRUE(message.starts_with("s.json:2: column 14: not valid JSON")) << message;
}

}  // namespace
}  // namespace spanline::host
