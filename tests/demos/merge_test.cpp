#include "assetc/merge.hpp"

#include <gtest/gtest.h>

#include "assetc/scene_json.hpp"
#include "demos/all.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"
#include "sim/unseen_merge.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kAnyNumber = 65535;

// A scene of one flat mesh from the text of its vertices and faces.
CompiledScene scene_of(const std::string& vertices, const std::string& faces) {
  return compile(parse_scene("test.json", R"({"meshes": [{"name": "m", "vertices": )" + vertices + R"(, "faces": )" +
                                              faces + R"(}], "instances": [{"mesh": "m"}]})"));
}

const MeshTables& merged(CompiledScene& scene) {
  scene.merge_coplanar(kAnyNumber);
  const SceneRecord record = scene.record();
  validated(record, "test.json");
  return scene.meshes()[0];
}

const std::string kGrid =
    "[[0,0,0],[1,0,0],[2,0,0],[3,0,0],[0,1,0],[1,1,0],[2,1,0],[3,1,0],"
    "[0,2,0],[1,2,0],[2,2,0],[3,2,0],[0,3,0],[1,3,0],[2,3,0],[3,3,0]]";

TEST(Merge, TwoTrianglesAreAQuad) {
  CompiledScene scene = scene_of(kGrid, "[[0,1,5],[0,5,4]]");
  const MeshTables& mesh = merged(scene);
  EXPECT_EQ(mesh.face_count, 1);
  EXPECT_EQ(mesh.corners.size(), 4u);
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.groups[0].contour_count, 1);
}

TEST(Merge, ARingOfQuadsHasAHoleAndKeepsStraightVertices) {
  CompiledScene scene =
      scene_of(kGrid, "[[0,1,5,4],[1,2,6,5],[2,3,7,6],[6,7,11,10],[10,11,15,14],[9,10,14,13],[8,9,13,12],[4,5,9,8]]");
  const MeshTables& mesh = merged(scene);
  ASSERT_EQ(mesh.face_count, 1);
  EXPECT_EQ(mesh.groups[0].contour_count, 2);
  EXPECT_EQ(mesh.contours, (std::vector<std::uint16_t>{12, 4}));
}

TEST(Merge, InnerVerticesGo) {
  CompiledScene scene = scene_of(kGrid, "[[0,1,5,4],[1,2,6,5],[4,5,9,8],[5,6,10,9]]");
  const MeshTables& mesh = merged(scene);
  EXPECT_EQ(mesh.face_count, 1);
  EXPECT_EQ(mesh.positions.size(), 8u);
}

TEST(Merge, AFoldStaysAnEdge) {
  CompiledScene scene = scene_of("[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[2,0,0.01],[2,1,0.01]]", "[[0,1,2,3],[1,4,5,2]]");
  EXPECT_EQ(merged(scene).face_count, 2);
}

TEST(Merge, OpposedAndDoubledFacesStay) {
  CompiledScene opposed = scene_of(kGrid, "[[0,1,5],[0,4,5]]");  // back to back over one edge
  EXPECT_EQ(merged(opposed).face_count, 2);
  CompiledScene doubled = scene_of(kGrid, "[[0,1,5],[0,1,5],[0,5,4]]");
  EXPECT_EQ(merged(doubled).face_count, 3);
}

// Faces that lie over one another in their plane would cancel under even-odd filling.
TEST(Merge, WhatOverlapsStays) {
  CompiledScene scene = scene_of("[[0,0,0],[2,0,0],[2,2,0],[0,2,0],[1,1,0],[-1,1.5,0]]", "[[0,1,2,3],[3,2,4,5]]");
  EXPECT_EQ(merged(scene).face_count, 2);
}

TEST(Merge, FacesThatTouchAtAVertexOnlyStay) {
  CompiledScene scene = scene_of(kGrid, "[[0,1,5,4],[5,6,10,9]]");
  EXPECT_EQ(merged(scene).face_count, 2);
}

TEST(Merge, BridgesToHolesGo) {
  CompiledScene scene = scene_of(kGrid, "[[0,3,15,12,0,5,9,10,6,5]]");
  const MeshTables& mesh = merged(scene);
  ASSERT_EQ(mesh.face_count, 1);
  EXPECT_EQ(mesh.contours, (std::vector<std::uint16_t>{4, 4}));
}

TEST(Merge, MaterialsStayApart) {
  CompiledScene scene = compile(parse_scene("test.json", R"({
    "materials": [{"name": "a", "color": [255, 0, 0]}, {"name": "b", "color": [0, 0, 255]}],
    "meshes": [{"name": "m", "obj": "assets/floor.obj"}], "instances": [{"mesh": "m"}]})"));
  scene.merge_coplanar(kAnyNumber);
  EXPECT_EQ(scene.meshes()[0].face_count, 64);  // a checkerboard: neighbours never share a colour
}

TEST(Merge, StaysWithinTheNumberOfCorners) {
  const std::string faces = "[[0,1,5,4],[1,2,6,5],[2,3,7,6]]";
  CompiledScene small = scene_of(kGrid, faces), large = scene_of(kGrid, faces);
  small.merge_coplanar(7);
  EXPECT_EQ(small.meshes()[0].face_count, 3);
  large.merge_coplanar(8);
  EXPECT_EQ(large.meshes()[0].face_count, 1);
}

Rendering rendering_of(CompiledScene& scene, std::int64_t frame) {
  scene.show(frame);
  EngineOptions options;
  options.width = scene.description().width;
  options.height = scene.description().height;
  options.observe = true;
  Rendering rendering;
  const SceneRecord record = scene.record();
  EXPECT_TRUE(Engine::make(options)->render(validated(record, "scene"), scene.camera(), rendering).ok());
  return rendering;
}

struct Difference {
  std::size_t pixels = 0;
  int most_in_depth = 0;  // of 65536
};

// What merging changes in four frames of the scene.
Difference changed(const SceneDescription& description, std::uint32_t most_corners) {
  CompiledScene plain = compile(description), joined = compile(description);
  joined.merge_coplanar(most_corners);
  std::size_t faces_before = 0, faces_after = 0;
  for (const MeshTables& mesh : plain.meshes()) faces_before += mesh.face_count;
  for (const MeshTables& mesh : joined.meshes()) faces_after += mesh.face_count;
  EXPECT_LT(faces_after, faces_before) << description.place;
  Difference difference;
  for (const std::int64_t frame : {0, 13, 40, 71}) {
    const Rendering a = rendering_of(plain, frame), b = rendering_of(joined, frame);
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
      const std::uint8_t *left = &a.picture.rgb[3 * i], *right = &b.picture.rgb[3 * i];
      if (std::equal(left, left + 3, right)) continue;
      ++difference.pixels;
      difference.most_in_depth = std::max(difference.most_in_depth, std::abs(a.depth[i] - b.depth[i]));
    }
  }
  return difference;
}

TEST(Merge, NotAPixelDiffers) {
  for (const char* scene :
       {"scenes/clockwork.json", "demos/gears.json", "demos/gauges.json", "demos/gauges_tall.json", "scenes/S1.json"}) {
    EXPECT_EQ(changed(read_scene(std::string("assets/") + scene), kMostMergedCorners).pixels, 0u) << scene;
  }
}

std::vector<std::uint8_t> picture_of(demos::Stage& stage, Engine& engine, std::uint32_t frame) {
  stage.show(frame);
  Rendering rendering;
  EXPECT_TRUE(engine.render(stage.view(), stage.camera(), rendering).ok());
  return rendering.picture.rgb;
}

// Frames of the demo in which the tables that the build made differ from those of the scene as it is written.
std::vector<std::uint32_t> frames_changed(demos::Demo demo, const Screen& screen, const std::string& scene,
                                          std::uint32_t loop) {
  EngineOptions options;
  options.width = screen.width;
  options.height = screen.height;
  options.format = screen.format;
  const std::unique_ptr<Engine> engine = Engine::make(options);
  const CompiledScene plain = compile(read_scene("assets/demos/" + scene + ".json"));
  const SceneRecord record = plain.record();
  demos::Stage built, written;
  EXPECT_TRUE(built.begin(demo, screen).ok());
  demo.shot.scene = &record;
  EXPECT_TRUE(written.begin(demo, screen).ok());
  std::vector<std::uint32_t> changed;
  for (std::uint32_t frame = 0; frame < loop; frame += 7) {
    if (picture_of(built, *engine, frame) != picture_of(written, *engine, frame)) changed.push_back(frame);
  }
  return changed;
}

TEST(Merge, NoPoseOfADemoShowsIt) {
  constexpr Screen kSmall{128, 64, PixelFormat::grey4};
  using Frames = std::vector<std::uint32_t>;
  // The others have nothing to merge, or are in triangles.
  EXPECT_EQ(frames_changed(demos::gears.framed_for(kSmall), kSmall, "gears_small", 600), Frames());
  EXPECT_EQ(frames_changed(demos::gauges.framed_for(kSmall), kSmall, "gauges_small", 360), Frames());
}

TEST(Merge, WhatWouldShowStaysApart) {
  CompiledScene scene = compile(read_scene("assets/scenes/island.json"));
  const std::size_t faces = scene.meshes()[0].face_count + scene.meshes()[1].face_count;
  const UnseenMerge merge = merge_unseen(scene, kMostMergedCorners);
  EXPECT_EQ(merge.kept_apart, std::vector<std::string>{"land"}) << "its shore is pierced by the lake";
  EXPECT_EQ(scene.meshes()[0].face_count + scene.meshes()[1].face_count, faces);
}

// The plane of a merged face is rounded from other corners than those of its parts: where something pierces it, the
// line may move by what that is worth.
TEST(Merge, WherePiercedADepthOfNothingDecides) {
  for (const char* scene : {"scenes/island.json", "demos/gears.json", "demos/gears_tall.json"}) {
    const Difference difference = changed(read_scene(std::string("assets/") + scene), kAnyNumber);
    EXPECT_LE(difference.pixels, 8u) << scene;
    EXPECT_LE(difference.most_in_depth, 2) << scene;
  }
}

}  // namespace
}  // namespace spanline::host
