// Gouraud's colours against their definition in doubles: linear along the two edges, then linear along the line.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/frame/frame.hpp"

namespace spanline {
namespace {

constexpr int kSize = 64;
constexpr Budget kBudget{.width = kSize,
                         .height = kSize,
                         .format = PixelFormat::grey8,
                         .facets = 8,
                         .vertices = 8,
                         .polygons = 8,
                         .edges = 8,
                         .segments = 8,
                         .samples = 16,
                         .implied = 4};

// A square that faces the camera at distance 4, focal length 64 px: 1 unit is 16 px. Corner normals are turned so that
// the light along -z gives every corner a brightness of its own.
struct Square {
  Position positions[4] = {{-16384, -16384, 0}, {16384, -16384, 0}, {16384, 16384, 0}, {-16384, 16384, 0}};
  std::uint16_t corners[4] = {0, 1, 2, 3};
  Normal10 normals[4];
  double brightness[4];
  FaceGroup group{0, 0, 1, 4, 0, 1, 0};
  MeshRecord mesh{};
  InstanceRecord instance{0};
  MaterialRecord material{{255, 255, 255}, MaterialRecord::kGouraud};
  LightRecord light{{{}, {}, {-Fx30::kOne}}, {256, 256, 256}};
  SceneRecord scene{};

  explicit Square(const double (&tilt)[4]) {
    for (int i = 0; i < 4; ++i) {
      const int z = static_cast<int>(std::lround(511 * std::cos(tilt[i])));
      normals[i] = Normal10::pack(static_cast<int>(std::lround(511 * std::sin(tilt[i]))), 0, z);
      brightness[i] = 255 * z / 511.0;
    }
    mesh.name = "square";
    mesh.positions = positions;
    mesh.vertex_normals = normals;
    mesh.corners = corners;
    mesh.groups = {&group, 1};
    mesh.face_count = 1;
    mesh.unit = 1 << 17;  // 16384 mesh units are a world unit
    scene.meshes = {&mesh, 1};
    scene.instances = {&instance, 1};
    scene.materials = {&material, 1};
    scene.lights = {&light, 1};
  }
};

CameraRecord four_units_away() {
  CameraRecord camera{};
  for (int i = 0; i < 3; ++i) camera.axes[i][i].raw = Fx30::kOne;
  camera.eye[2] = Fx16::from_int(4);
  camera.focal = Fx12::from_int(64);
  camera.near_plane = Fx16::from_int(1);
  camera.far_plane = Fx16::from_int(10);
  return camera;
}

TEST(Gouraud, IsLinearBetweenTheEdges) {
  constexpr double kTilts[][4] = {{0, 1.2, 0.4, 0.9}, {1.5, 0, 1.5, 0}, {0.3, 0.3, 1.4, 1.4}};
  for (const auto& tilt : kTilts) {
    Square square(tilt);
    SceneView view;
    ASSERT_TRUE(SceneView::validate(square.scene, view).ok());
    const CameraRecord camera = four_units_away();
    FrameMemory<kBudget> memory;
    Frame<> frame(memory.storage());
    ASSERT_FALSE(frame.prepare(view, camera, {0, kSize}).empty());
    alignas(4) std::uint8_t line[kSize];
    for (int y = 0; frame.next_line(line); ++y) {
      const double down = (y + 0.5 - 16) / 32;
      if (down < 0 || down > 1) continue;
      const double left = square.brightness[3] * (1 - down) + square.brightness[0] * down;
      const double right = square.brightness[2] * (1 - down) + square.brightness[1] * down;
      for (int x = 16; x < 48; ++x) {
        const double across = (x - 16) / 32.0;  // colours start at the first column of the line
        EXPECT_NEAR(line[x], left * (1 - across) + right * across, 1.6) << x << ' ' << y;
      }
      EXPECT_EQ(line[15], 0);
      EXPECT_EQ(line[48], 0);
    }
    EXPECT_TRUE(frame.status().ok());
  }
}

TEST(Gouraud, IsFlatWhereTheBudgetHasNoRoomForColours) {
  static constexpr Budget kPlain{.width = kSize, .height = kSize, .format = PixelFormat::grey8, .gouraud = false};
  Square square({0.5, 1, 1, 1});
  SceneView view;
  ASSERT_TRUE(SceneView::validate(square.scene, view).ok());
  const CameraRecord camera = four_units_away();
  FrameMemory<kPlain> memory;
  Frame<> frame(memory.storage());
  ASSERT_FALSE(frame.prepare(view, camera, {0, kSize}).empty());
  alignas(4) std::uint8_t line[kSize];
  for (int y = 0; frame.next_line(line); ++y) {
    if (y < 16 || y >= 48) continue;
    EXPECT_NEAR(line[32], square.brightness[0], 1) << "the first corner's shade";
  }
}

}  // namespace
}  // namespace spanline
