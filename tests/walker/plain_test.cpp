// A frame for plain scenes alone (Budget::plain) draws what one for all scenes does, and refuses the others by name.
#include <gtest/gtest.h>

#include <string_view>

#include "core/shade/light.hpp"
#include "vsg/scale.hpp"
#include "walker/band_memory.hpp"
#include "walker/decisions.hpp"

namespace spanline::test {
namespace {

template <Paint kPaint, bool kPlain>
Decisions draw_with(const SceneRecord& record, const CameraRecord& camera, const Screen& screen) {
  SceneView view;
  EXPECT_TRUE(SceneView::validate(record, view).ok());
  Memory memory(screen, 2000, kPaint == Paint::smooth_words);
  constexpr FrameOptions kOptions{.walker = Walker::edges, .paint = kPaint, .plain = kPlain};
  return draw_by<kOptions>(memory.memory.storage(), view, camera, 9);
}

// In bands, with room for some of the vertices.
template <Paint kPaint>
Decisions draw_in_bands(const SceneRecord& record, const CameraRecord& camera, const Screen& screen) {
  SceneView view;
  EXPECT_TRUE(SceneView::validate(record, view).ok());
  constexpr bool kSmooth = kPaint == Paint::smooth_words;
  BandMemory memory(
      view, screen,
      {.vertices = 40, .lines = screen.height, .looks = 15, .tables = kSmooth, .planes = 7, .gouraud = kSmooth});
  constexpr FrameOptions kOptions{.walker = Walker::edges, .bands = true, .paint = kPaint, .plain = true};
  return draw_by<kOptions>(memory.storage, view, camera, 9);
}

template <Paint kPaint>
void expect_as_every_frame(const SceneRecord& record, const CameraRecord& camera, const Screen& screen) {
  const Decisions plain = draw_with<kPaint, true>(record, camera, screen);
  const Decisions any = draw_with<kPaint, false>(record, camera, screen);
  EXPECT_EQ(plain.status.ok(), any.status.ok()) << plain.status.where << " " << plain.status.field;
  EXPECT_TRUE(plain.bytes == any.bytes) << "other bytes";
  const Decisions bands = draw_in_bands<kPaint>(record, camera, screen);
  EXPECT_EQ(bands.status.ok(), any.status.ok()) << bands.status.where << " " << bands.status.field;
  EXPECT_TRUE(bands.bytes == any.bytes) << "other bytes in bands";
}

MeshScene plain_scene(std::uint64_t seed) {
  MeshScene scene = random_mesh_scene(seed + 3000000);
  scene.screen.format = PixelFormat::rgb565;
  if (scene.lights.empty()) scene.lights.push_back({{{}, {}, {-Fx30::kOne}}, {}});
  scene.lights.resize(1);
  const auto bright = static_cast<std::uint16_t>(1 + seed * 37 % 200),
             dark = static_cast<std::uint16_t>(seed * 11 % 57);
  for (int i = 0; i < 3; ++i) {
    scene.lights[0].intensity[i] = bright;
    scene.ambient[i] = dark;
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if ((seed + i) % 7 == 0) scene.materials[i].shading = MaterialRecord::kUnlit;
  }
  return scene;
}

// All of its faces.
void make_smooth(MeshScene& scene) {
  for (MaterialRecord& material : scene.materials) material.shading = MaterialRecord::kGouraud;
}

SceneRecord record_of(MeshScene& scene) {
  SceneRecord record = scene.record();
  record.background.bottom = record.background.top;
  return record;
}

TEST(Plain, FramesDrawWhatEveryFrameDraws) {
  for (std::uint64_t seed = 0, end = scene_count(300, 8000); seed < end && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    MeshScene scene = plain_scene(seed);
    expect_as_every_frame<Paint::flat_words>(record_of(scene), scene.camera, scene.screen);
    make_smooth(scene);
    expect_as_every_frame<Paint::smooth_words>(record_of(scene), scene.camera, scene.screen);
  }
}

// The light of one instance is that of a rig that knows all kinds, bit by bit.
TEST(Plain, LightIsThatOfTheRig) {
  for (std::uint64_t seed = 0, end = scene_count(300, 8000); seed < end && !HasFailure(); ++seed) {
    MeshScene scene = plain_scene(seed);
    const SceneRecord record = record_of(scene);
    for (const InstanceRecord& instance : scene.instances) {
      const LightRig rig(record, instance.transform);
      const PlainLight plain(record, instance.transform);
      ASSERT_EQ(plain.fits(), rig.quick() && !is_mirrored(instance.transform));
      if (!plain.fits()) continue;
      const LightRig::One one = rig.one();
      EXPECT_EQ(plain.one().x, one.x);
      EXPECT_EQ(plain.one().y, one.y);
      EXPECT_EQ(plain.one().z, one.z);
      EXPECT_EQ(plain.one().intensity, one.intensity);
      EXPECT_EQ(plain.one().ambient, one.ambient);
    }
  }
}

// What a plain frame of the scene says it is not; "" where it draws it.
template <Paint kPaint = Paint::flat_words>
std::string refusal(const SceneRecord& record, const MeshScene& scene) {
  const Decisions drawn = draw_with<kPaint, true>(record, scene.camera, scene.screen);
  EXPECT_EQ(drawn.status.ok(), !drawn.bytes.empty());
  const Decisions bands = draw_in_bands<kPaint>(record, scene.camera, scene.screen);
  EXPECT_EQ(bands.status.ok(), drawn.status.ok());
  // They ask first whether vertices are out of the view.
  if (std::string_view(bands.status.field ? bands.status.field : "") != "transform (beyond the view)") {
    EXPECT_EQ(bands.status.code, drawn.status.code);
    EXPECT_STREQ(bands.status.where, drawn.status.where);
    EXPECT_STREQ(bands.status.field, drawn.status.field);
  }
  if (drawn.status.ok()) return "";
  EXPECT_EQ(drawn.status.code, Code::bad_argument);
  EXPECT_STREQ(drawn.status.where, "plain");
  return drawn.status.field;
}

TEST(Plain, OtherScenesAreRefusedByWhatTheyAreNot) {
  MeshScene scene = plain_scene(0);
  for (InstanceRecord& instance : scene.instances) instance.flags = 0;
  ASSERT_EQ(refusal(record_of(scene), scene), "");
  const LightRecord light = scene.lights[0];
  scene.lights.push_back(light);
  EXPECT_EQ(refusal(record_of(scene), scene), "lights");
  scene.lights.clear();
  EXPECT_EQ(refusal(record_of(scene), scene), "lights");
  for (const std::uint16_t red : {std::uint16_t{0}, std::uint16_t{250}}) {  // black with the others, or a hue
    scene.lights = {light};
    scene.lights[0].intensity[0] = red;
    if (red == 0) scene.lights[0].intensity[1] = scene.lights[0].intensity[2] = 0;
    EXPECT_EQ(refusal(record_of(scene), scene), "lights");
  }
  scene.lights = {light};
  for (std::uint16_t& channel : scene.lights[0].intensity) channel = 257;  // saturates
  EXPECT_EQ(refusal(record_of(scene), scene), "lights");
  scene.lights = {light};
  scene.ambient[1] ^= 1;
  EXPECT_EQ(refusal(record_of(scene), scene), "lights");
  scene.ambient[1] ^= 1;
  SceneRecord record = record_of(scene);
  record.background.bottom.b ^= 8;
  EXPECT_EQ(refusal(record, scene), "background");
  scene.materials[0].transmission = {0, 8, 0};
  EXPECT_EQ(refusal(record_of(scene), scene), "materials");
  scene.materials[0].transmission = {};
  const std::vector<MaterialRecord> materials = scene.materials;
  make_smooth(scene);
  EXPECT_EQ(refusal<Paint::smooth_words>(record_of(scene), scene), "");
  for (MaterialRecord& material : scene.materials) material.shading = MaterialRecord::kFlat;
  EXPECT_EQ(refusal<Paint::smooth_words>(record_of(scene), scene), "materials");
  scene.materials = materials;
  scene.instances[0].flags = InstanceRecord::kTwoSided;
  EXPECT_EQ(refusal(record_of(scene), scene), "instances");
  scene.instances[0].flags = 0;
  record = record_of(scene);
  MeshRecord mesh = record.meshes[scene.instances[0].mesh];
  mesh.face_normals = {};
  scene.mesh_records[scene.instances[0].mesh] = mesh;
  record.meshes = {scene.mesh_records.data(), static_cast<std::uint32_t>(scene.mesh_records.size())};
  EXPECT_EQ(refusal(record, scene), "transform or normals");
  mesh.fans = {};
  mesh.fan_starts = {};
  scene.mesh_records[scene.instances[0].mesh] = mesh;
  EXPECT_EQ(refusal(record, scene), "meshes");
  scene = plain_scene(0);
  for (InstanceRecord& instance : scene.instances) instance.flags = 0;
  auto& row = scene.instances[0].transform.matrix[0];
  for (Fx16& entry : row) entry.raw = -entry.raw;  // mirrored
  EXPECT_EQ(refusal(record_of(scene), scene), "transform or normals");
  for (Fx16& entry : row) entry.raw = -entry.raw + entry.raw / 8;  // uneven
  EXPECT_EQ(refusal(record_of(scene), scene), "transform or normals");
}

}  // namespace
}  // namespace spanline::test
