#include "assetc/camera.hpp"

#include <gtest/gtest.h>

#include "host/support.hpp"

namespace spanline::host {
namespace {

TEST(DefaultCamera, FitsTheSphereIntoNineTenthsOfTheHeight) {
  for (const double fov : {20.0, 45.0, 100.0}) {
    CameraSpec camera;
    camera.fov = fov;
    const Sphere bounds{{5, -3, 2}, 7};
    const View view = view_in_frame(camera, bounds, 240, 0, "s");
    const double distance = length(view.eye - bounds.centre);
    // The cone that touches the sphere has this half angle.
    const double half = std::asin(bounds.radius / distance);
    EXPECT_NEAR(std::tan(half), 0.9 * std::tan(radians(fov) / 2), 1e-12);
    const Vec3 from = unit_or(view.eye - bounds.centre, {});
    EXPECT_NEAR(length(cross(from, unit_or({1, 0.8, 1.6}, {}))), 0, 1e-12);
    EXPECT_LE(view.near, distance - bounds.radius);
    EXPECT_GE(view.far, distance + bounds.radius);
  }
}

TEST(DefaultCamera, TakesAPointForASphereOfOne) {
  const View view = view_in_frame({}, {{1, 2, 3}, 0}, 240, 0, "s");
  EXPECT_GT(view.near, 0);
  EXPECT_GT(view.far, view.near);
}

TEST(DefaultCamera, KeepsNearInFrontInsideTheScene) {
  CameraSpec camera;
  camera.has_eye = camera.has_target = true;
  camera.eye = {0, 0, 1};
  const View view = view_in_frame(camera, {{}, 100}, 240, 0, "s");
  EXPECT_GT(view.near, 0);
  EXPECT_LT(view.near, view.far);
}

TEST(Camera, RowsAreRightUpAndBack) {
  const Axes axes = axes_of({{0, 0, 5}, {0, 0, 0}, {0, 3, 0}, 45, 1, 10});
  EXPECT_EQ(axes.right, (Vec3{1, 0, 0}));
  EXPECT_EQ(axes.up, (Vec3{0, 1, 0}));
  EXPECT_EQ(axes.back, (Vec3{0, 0, 1}));
}

TEST(Camera, RecordHasTheFocalLengthOfTheAngle) {
  const CameraRecord record = camera_record({{0, 0, 5}, {}, {0, 1, 0}, 90, 1, 10}, {2, {}}, 240);
  EXPECT_EQ(record.focal.raw, 120 * 4096);
  EXPECT_EQ(record.eye[2].raw, 10 * 65536);
  EXPECT_EQ(record.near_plane.raw, 2 * 65536);
  EXPECT_EQ(record.far_plane.raw, 20 * 65536);
}

TEST(DefaultLight, ComesFromBehindAboveAndLeft) {
  const Axes axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vec3 light = default_light(axes);
  EXPECT_GT(light.x, 0);
  EXPECT_LT(light.y, 0);
  EXPECT_LT(light.z, 0);
  EXPECT_NEAR(length(light), 1, 1e-12);
}

TEST(Camera, MovingIntoItsTargetNamesTheFrame) {
  CameraSpec camera;
  camera.has_eye = camera.has_target = true;
  camera.motion.frames = 10;
  camera.motion.loop = false;
  camera.motion.keys = {{0, {0, 0, 5, 0, 0, 0, 0, 1, 0, 45}}, {10, {0, 0, -5, 0, 0, 0, 0, 1, 0, 45}}};
  EXPECT_EQ(message_of([&] {
              view_in_frame(camera, {{}, 1}, 240, 5, "s.json");
            }),
            "s.json: the camera's eye is at its target in frame 5");
}

}  // namespace
}  // namespace spanline::host
