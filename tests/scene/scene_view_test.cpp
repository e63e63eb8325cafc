#include "core/scene/scene_view.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace spanline {
namespace {

template <typename T>
Slice<const T> slice_of(const std::vector<T>& items) {
  return {items.data(), static_cast<std::uint32_t>(items.size())};
}

// Two triangles, a square with a triangular hole, three materials, two instances, one light: valid, and open to any
// mutation.
struct Fixture {
  std::vector<Position> positions = std::vector<Position>(9);
  std::vector<Normal10> vertex_normals = std::vector<Normal10>(9, Normal10::pack(0, 0, 511));
  std::vector<Normal10> face_normals = std::vector<Normal10>(3, Normal10::pack(0, 0, 511));
  std::vector<std::uint16_t> corners{0, 1, 2, 2, 1, 3, 0, 1, 3, 2, 4, 5, 6};
  std::vector<std::uint16_t> contours{4, 3};
  std::vector<FaceGroup> groups{{0, 0, 2, 3, 0, 1, 0}, {6, 2, 1, 7, 0, 2, 1}};
  std::vector<MaterialRecord> materials{
      {{1, 2, 3}, MaterialRecord::kFlat}, {{4, 5, 6}, MaterialRecord::kGouraud}, {{7, 8, 9}, MaterialRecord::kUnlit}};
  std::vector<InstanceRecord> instances;
  std::vector<CurveRecord> curves{{0, 4, CurveRecord::kBezier, CurveRecord::kOpen, 16, 0},
                                  {4, 3, CurveRecord::kBSpline, CurveRecord::kClosed, 0, 2}};
  std::vector<LightRecord> lights{{{{}, {}, Fx30::from_int(-1)}, {256, 256, 256}}};
  MeshRecord mesh{};
  std::vector<MeshRecord> meshes;
  std::uint32_t claimed = 0;  // vertices that the record speaks of, 0: those that there are

  Fixture() {
    mesh.name = "fixture";
    mesh.face_count = 3;
    mesh.unit = 1 << 20;
    instances.resize(2);
    instances[0].mesh = instances[1].mesh = 0;
  }

  // Slices made anew, so that a mutation may change sizes.
  SceneRecord record() {
    mesh.positions = {positions.data(), claimed == 0 ? static_cast<std::uint32_t>(positions.size()) : claimed};
    mesh.vertex_normals = slice_of(vertex_normals);
    if (claimed != 0) mesh.vertex_normals = {vertex_normals.data(), claimed};
    mesh.face_normals = slice_of(face_normals);
    mesh.corners = slice_of(corners);
    mesh.contours = slice_of(contours);
    mesh.groups = slice_of(groups);
    mesh.curves = slice_of(curves);
    meshes = {mesh};
    SceneRecord scene{};
    scene.meshes = slice_of(meshes);
    scene.instances = slice_of(instances);
    scene.materials = slice_of(materials);
    scene.lights = slice_of(lights);
    return scene;
  }
};

struct BadCase {
  const char* where;
  const char* field;  // the status's field must begin with it
  std::uint32_t index;
  std::function<void(Fixture&)> spoil;
};

std::vector<BadCase> bad_cases() {
  const auto big = Fx16::from_int(kMaxWorld + 1);
  return {
      {"MaterialRecord", "shading", 1,
       [](Fixture& f) { f.materials[1].shading = static_cast<MaterialRecord::Shading>(3); }},
      {"SceneRecord", "lights", 0, [](Fixture& f) { f.lights.resize(kMaxLights + 1, f.lights[0]); }},
      {"LightRecord", "direction", 0, [](Fixture& f) { f.lights[0].direction[2] = {}; }},
      {"LightRecord", "direction", 1,
       [](Fixture& f) {
         f.lights.push_back({{Fx30::from_int(1), Fx30::from_int(1), {}}, {1, 1, 1}});
       }},
      {"MeshRecord", "positions", 0, [](Fixture& f) { f.positions.clear(); }},
      {"MeshRecord", "positions", 0, [](Fixture& f) { f.claimed = kMaxSceneVertices + 1; }},
      {"MeshRecord", "vertex_normals", 0, [](Fixture& f) { f.vertex_normals.pop_back(); }},
      {"MeshRecord", "face_normals", 0, [](Fixture& f) { f.face_normals.pop_back(); }},
      {"MeshRecord", "corners", 0, [](Fixture& f) { f.corners[5] = 9; }},
      {"MeshRecord", "box", 0, [](Fixture& f) { f.mesh.box.low.x = 1; }},
      {"MeshRecord", "box", 0,
       [](Fixture& f) {
         f.positions[4].z = 7, f.mesh.box = {{0, 0, 0}, {0, 0, 6}};
       }},
      {"MeshRecord", "unit", 0, [](Fixture& f) { f.mesh.unit = 0; }},
      {"MeshRecord", "unit", 0, [](Fixture& f) { f.mesh.unit = -1; }},
      {"MeshRecord", "origin", 0, [big](Fixture& f) { f.mesh.origin[1] = big; }},
      {"MeshRecord", "origin", 0, [big](Fixture& f) { f.mesh.origin[2] = -big; }},
      {"MeshRecord", "face_count", 0, [](Fixture& f) { f.mesh.face_count = 4, f.face_normals.resize(4); }},
      {"MeshRecord", "face_count", 0,
       [](Fixture& f) { f.mesh.face_count = 0, f.groups.clear(), f.face_normals.clear(), f.curves.clear(); }},
      {"FaceGroup", "contour_count", 1, [](Fixture& f) { f.groups[1].contour_count = FaceGroup::kCurved; }},
      {"FaceGroup", "contours (curved)", 1, [](Fixture& f) { f.groups[1].contour_count |= FaceGroup::kCurved; }},
      {"FaceGroup", "corners_per_face (curved)", 0,
       [](Fixture& f) { f.groups[0].contour_count |= FaceGroup::kCurved; }},
      {"CurveRecord", "kind", 1, [](Fixture& f) { f.curves[1].kind = static_cast<CurveRecord::Kind>(4); }},
      {"CurveRecord", "point_count", 0, [](Fixture& f) { f.curves[0].point_count = 5; }},
      {"CurveRecord", "point_count", 0, [](Fixture& f) { f.curves[0].point_count = 0; }},
      {"CurveRecord", "point_count", 0, [](Fixture& f) { f.curves[0].kind = CurveRecord::kQuadratic; }},
      {"CurveRecord", "point_count", 0, [](Fixture& f) { f.curves[0].flags = CurveRecord::kClosed; }},
      {"CurveRecord", "point_count", 1, [](Fixture& f) { f.curves[1].point_count = 2; }},
      {"CurveRecord", "point_count", 1, [](Fixture& f) { f.curves[1].flags = CurveRecord::kOpen; }},
      {"CurveRecord", "first_corner", 0, [](Fixture& f) { f.curves[0].first_corner = 10; }},
      {"CurveRecord", "first_corner", 0, [](Fixture& f) { f.curves[0].first_corner = 0xffffffff; }},
      {"CurveRecord", "width", 0, [](Fixture& f) { f.curves[0].width = CurveRecord::kMaxWidth + 1; }},
      {"CurveRecord", "material", 1, [](Fixture& f) { f.curves[1].material = 3; }},
      {"FaceGroup", "first_face", 1, [](Fixture& f) { f.groups[1].first_face = 3; }},
      {"FaceGroup", "first_face", 1, [](Fixture& f) { f.groups[1].first_face = 1; }},
      {"FaceGroup", "face_count", 1, [](Fixture& f) { f.groups[1].face_count = 0; }},
      {"FaceGroup", "corners_per_face", 0, [](Fixture& f) { f.groups[0].corners_per_face = 2; }},
      {"FaceGroup", "first_corner", 0, [](Fixture& f) { f.groups[0].first_corner = 8; }},
      {"FaceGroup", "first_corner", 0, [](Fixture& f) { f.groups[0].first_corner = 0xffffffff; }},
      {"FaceGroup", "material", 1, [](Fixture& f) { f.groups[1].material = 3; }},
      {"FaceGroup", "contour_count", 1, [](Fixture& f) { f.groups[1].contour_count = FaceGroup::kPatches; }},
      {"FaceGroup", "corners_per_face", 0, [](Fixture& f) { f.groups[0].contour_count = FaceGroup::kPatches; }},
      {"FaceGroup", "first_contour", 1, [](Fixture& f) { f.groups[1].first_contour = 1; }},
      {"FaceGroup", "first_contour", 1, [](Fixture& f) { f.groups[1].first_contour = 0xffff; }},
      {"FaceGroup", "contours", 1,
       [](Fixture& f) {
         f.contours = {5, 2};
       }},
      {"FaceGroup", "contours", 1,
       [](Fixture& f) {
         f.contours = {4, 4};
       }},
      {"FaceGroup", "contours", 1,
       [](Fixture& f) {
         f.contours = {3, 3};
       }},
      {"InstanceRecord", "mesh", 1, [](Fixture& f) { f.instances[1].mesh = 1; }},
      {"InstanceRecord", "material", 1, [](Fixture& f) { f.instances[1].material = 3; }},
      {"InstanceRecord", "transform", 0, [big](Fixture& f) { f.instances[0].transform.translation[0] = big; }},
      {"InstanceRecord", "transform", 1, [big](Fixture& f) { f.instances[1].transform.translation[2] = -big; }},
      {"InstanceRecord", "material", 0, [](Fixture& f) { f.vertex_normals.clear(); }},
      {"InstanceRecord", "material", 0, [](Fixture& f) { f.face_normals.clear(); }},
      {"InstanceRecord", "material", 1,
       [](Fixture& f) { f.instances[0].material = 2, f.instances[1].material = 0, f.face_normals.clear(); }},
      {"InstanceRecord", "material", 0, [](Fixture& f) { f.instances[0].flags = InstanceRecord::kScreen; }},
      {"InstanceRecord", "material", 0,
       [](Fixture& f) { f.instances[0].flags = InstanceRecord::kScreen, f.instances[0].material = 0; }},
      {"SceneRecord", "instances", 1, [](Fixture& f) { f.claimed = kMaxSceneVertices / 2 + 1; }},
  };
}

TEST(SceneView, AcceptsASoundScene) {
  Fixture fixture;
  const SceneRecord scene = fixture.record();
  SceneView view;
  const Status status = SceneView::validate(scene, view);
  ASSERT_TRUE(status.ok()) << status.where << " " << status.field;
  EXPECT_EQ(view.face_count(), 6);
  EXPECT_EQ(view.vertex_count(), 18);
  EXPECT_EQ(view.curve_count(), 4);
  EXPECT_EQ(&view.scene(), &scene);
}

TEST(SceneView, AcceptsUnlitMeshesWithoutNormals) {
  Fixture fixture;
  fixture.vertex_normals.clear();
  fixture.face_normals.clear();
  for (InstanceRecord& instance : fixture.instances) instance.material = 2;
  SceneView view;
  EXPECT_TRUE(SceneView::validate(fixture.record(), view).ok());
}

TEST(SceneView, AcceptsUnlitMeshesOnTheScreen) {
  Fixture fixture;
  fixture.instances[0].flags = InstanceRecord::kScreen;
  fixture.instances[0].material = 2;
  SceneView view;
  EXPECT_TRUE(SceneView::validate(fixture.record(), view).ok());
}

TEST(SceneView, AcceptsNothingAtAll) {
  SceneView view;
  EXPECT_TRUE(SceneView::validate(SceneRecord{}, view).ok());
  EXPECT_EQ(view.face_count(), 0);
}

TEST(SceneView, NamesRecordIndexAndFieldOfWhatIsWrong) {
  int number = 0;
  for (const BadCase& bad : bad_cases()) {
    SCOPED_TRACE(testing::Message() << "case " << number++ << ": " << bad.where << "::" << bad.field);
    Fixture fixture;
    bad.spoil(fixture);
    const SceneRecord scene = fixture.record();
    const SceneRecord before{};
    SceneView view;
    ASSERT_TRUE(SceneView::validate(before, view).ok());
    const Status status = SceneView::validate(scene, view);
    EXPECT_EQ(status.code, Code::bad_record);
    EXPECT_STREQ(status.where, bad.where);
    EXPECT_EQ(std::string(status.field).rfind(bad.field, 0), 0u) << status.field;
    EXPECT_EQ(status.index, bad.index);
    EXPECT_EQ(&view.scene(), &before) << "a refused scene must leave the view as it was";
  }
}

}  // namespace
}  // namespace spanline
