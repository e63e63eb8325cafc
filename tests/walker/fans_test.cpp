// The fans that the scene compiler makes, and what SceneView says to others.
#include "assetc/fans.hpp"

#include <gtest/gtest.h>

#include "core/scene/scene_view.hpp"
#include "walker/random_mesh_scene.hpp"

namespace spanline::test {
namespace {

// A tetrahedron without its base, and a flap on one edge that has two faces already.
host::MeshTables tent() {
  host::MeshTables mesh;
  mesh.name = "tent";
  mesh.positions = {{0, 9, 0}, {-5, 0, -5}, {5, 0, -5}, {0, 0, 5}, {9, 9, 9}};
  mesh.corners = {0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 3, 4, 2, 2, 3};
  mesh.face_count = 5;
  mesh.groups = {{0, 0, 5, 3, 0, 1, 0}};
  mesh.unit = 1 << 20;
  host::build_fans(mesh);
  return mesh;
}

std::string text_of(const host::MeshTables& mesh, std::size_t vertex) {
  std::string text;
  for (std::size_t i = mesh.fan_starts[vertex]; i < mesh.fan_starts[vertex + 1]; ++i) {
    const auto face = [](std::uint16_t f) { return f == FanEdge::kNone ? std::string("-") : std::to_string(f); };
    text += std::to_string(mesh.fans[i].to) + ":" + face(mesh.fans[i].face) + " ";
  }
  return text;
}

TEST(Fans, GoRoundTheirVertices) {
  const host::MeshTables mesh = tent();
  EXPECT_EQ(text_of(mesh, 0), "0:- 3:3 4:- 0:2 1:0 2:1 3:2 ");
  EXPECT_EQ(text_of(mesh, 3), "1:2 0:1 2:- 4:3 0:- ");
  EXPECT_EQ(text_of(mesh, 4), "0:3 3:- ");
}

TEST(Fans, AreForTrianglesOnly) {
  host::MeshTables mesh = tent();
  mesh.groups = {{0, 0, 3, 5, 0, 1, 0}};
  host::build_fans(mesh);
  EXPECT_TRUE(mesh.fans.empty() && mesh.fan_starts.empty());
}

TEST(Fans, AreForVerticesWithoutCrowdsOfNeighbours) {
  for (const std::uint16_t sides :
       {std::uint16_t{FanEdge::kMostInFan / 2}, std::uint16_t{FanEdge::kMostInFan / 2 + 1}}) {
    host::MeshTables cone = tent();
    cone.positions.assign(sides + 1u, {});
    cone.corners.clear();
    for (std::uint16_t i = 0; i < sides; ++i) {
      const auto next = static_cast<std::uint16_t>(i + 1 == sides ? 1 : i + 2);
      cone.corners.insert(cone.corners.end(), {0, static_cast<std::uint16_t>(i + 1), next});
    }
    cone.face_count = cone.groups[0].face_count = sides;
    host::build_fans(cone);
    EXPECT_EQ(cone.fans.size(), sides > FanEdge::kMostInFan / 2 ? 0u : 4u * sides);
  }
}

class SpoiltFans : public testing::Test {
 protected:
  // Whether SceneView takes the tent after `spoil`.
  template <typename Spoil>
  bool taken(const Spoil& spoil) {
    MeshScene scene = random_mesh_scene(0);
    scene.meshes.assign(1, tent());
    for (InstanceRecord& instance : scene.instances) instance.mesh = 0;
    for (MaterialRecord& material : scene.materials) material.shading = MaterialRecord::kUnlit;
    spoil(scene.meshes[0]);
    const SceneRecord record = scene.record();
    SceneView view;
    const Status status = SceneView::validate(record, view);
    if (status.ok()) return true;
    EXPECT_STREQ(status.where, "MeshRecord");
    return false;
  }
};

TEST_F(SpoiltFans, AreRefused) {
  using Mesh = host::MeshTables;
  EXPECT_TRUE(taken([](Mesh&) {}));
  for (std::size_t i = 0; i < tent().fans.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_FALSE(taken([i](Mesh& m) { m.fans[i].to = 77; }));
    EXPECT_FALSE(taken([i](Mesh& m) { m.fans[i].to = m.fans[i].to == 1 ? 2 : 1; }));
    EXPECT_FALSE(taken([i](Mesh& m) { m.fans[i].face = m.fans[i].face == 4 ? 3 : 4; }));
    EXPECT_FALSE(taken([i](Mesh& m) { m.fans[i].face = 9; }));
    EXPECT_FALSE(taken([i](Mesh& m) { m.fans[i] = m.fans[(i + 1) % m.fans.size()]; }));
  }
  EXPECT_FALSE(taken([](Mesh& m) { m.fan_starts.pop_back(); }));
  EXPECT_FALSE(taken([](Mesh& m) { m.fan_starts[1] = 9; }));
  EXPECT_FALSE(taken([](Mesh& m) { m.fans.pop_back(); }));
  EXPECT_FALSE(taken([](Mesh& m) { m.fans.clear(); }));
}

}  // namespace
}  // namespace spanline::test
