#include "core/geom/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/random.hpp"

namespace spanline {
namespace {

struct View {
  Fx16 eye[3], target[3], up[3];
  Fx12 focal = Fx12::from_int(100);
  Fx16 near_plane = Fx16::from_int(1), far_plane = Fx16::from_int(100);

  Status look(CameraRecord& camera) const { return look_at(eye, target, up, focal, near_plane, far_plane, camera); }
};

View from(int x, int y, int z) {
  View view;
  view.eye[0] = Fx16::from_int(x);
  view.eye[1] = Fx16::from_int(y);
  view.eye[2] = Fx16::from_int(z);
  view.up[1] = Fx16::from_int(1);
  return view;
}

long double unit(Fx30 value) { return std::ldexp(static_cast<long double>(value.raw), -30); }

long double dot(const Fx30 (&a)[3], const Fx30 (&b)[3]) {
  return unit(a[0]) * unit(b[0]) + unit(a[1]) * unit(b[1]) + unit(a[2]) * unit(b[2]);
}

TEST(LookAt, FromTheFrontIsTheWorldsOwnFrame) {
  CameraRecord camera{};
  ASSERT_TRUE(from(0, 0, 5).look(camera).ok());
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_EQ(camera.axes[row][column].raw, row == column ? Fx30::kOne : 0) << row << ", " << column;
    }
  }
}

TEST(LookAt, IsOrthonormalAndLooksAtTheTarget) {
  oracle::Random random(3);
  for (int i = 0; i < 5000; ++i) {
    View view;
    const int size = 1 << random.between(2, 27);
    for (int k = 0; k < 3; ++k) {
      view.eye[k].raw = random.between(-size, size);
      view.target[k].raw = random.between(-size, size);
      view.up[k].raw = random.between(-65536, 65536);
    }
    CameraRecord camera{};
    if (!view.look(camera).ok()) continue;
    const long double slack = std::ldexp(1.0L, -27);  // of products; of lengths half as much
    long double back[3], length = 0;
    for (int k = 0; k < 3; ++k) {
      back[k] = static_cast<long double>(view.eye[k].raw) - view.target[k].raw;
      length += back[k] * back[k];
    }
    for (int row = 0; row < 3; ++row) {
      for (int other = 0; other < 3; ++other) {
        ASSERT_NEAR(static_cast<double>(dot(camera.axes[row], camera.axes[other])), row == other,
                    static_cast<double>(slack))
            << i << ": rows " << row << ", " << other;
      }
      ASSERT_NEAR(static_cast<double>(unit(camera.axes[2][row])), static_cast<double>(back[row] / std::sqrt(length)),
                  1e-8);
    }
    // Right-handed: right x up = back.
    const auto& a = camera.axes;
    ASSERT_NEAR(static_cast<double>(unit(a[0][0]) * unit(a[1][1]) - unit(a[0][1]) * unit(a[1][0])),
                static_cast<double>(unit(a[2][2])), 1e-8);
  }
}

TEST(LookAt, RefusesWhatGivesNoDirection) {
  CameraRecord camera{};
  EXPECT_STREQ(from(0, 0, 0).look(camera).field, "target");
  EXPECT_STREQ(from(0, 5, 0).look(camera).field, "up");
  View no_up = from(0, 0, 5);
  no_up.up[1] = {};
  EXPECT_STREQ(no_up.look(camera).field, "up");
  EXPECT_EQ(no_up.look(camera).code, Code::bad_argument);
}

TEST(LookAt, LeavesTheCameraAloneWhenItFails) {
  CameraRecord camera{};
  camera.focal.raw = 77;
  EXPECT_FALSE(from(0, 0, 0).look(camera).ok());
  EXPECT_EQ(camera.focal.raw, 77);
}

TEST(CheckCamera, NamesTheField) {
  CameraRecord good{};
  ASSERT_TRUE(from(1, 2, 3).look(good).ok());
  ASSERT_TRUE(check_camera(good).ok());
  const auto field_of = [&good](auto spoil) {
    CameraRecord camera = good;
    spoil(camera);
    const Status status = check_camera(camera);
    EXPECT_EQ(status.code, Code::bad_argument);
    return std::string(status.field);
  };
  EXPECT_EQ(field_of([](CameraRecord& c) { c.eye[1] = Fx16::from_int(2 * kMaxWorld + 1); }), "eye");
  EXPECT_EQ(field_of([](CameraRecord& c) { c.axes[1][1].raw /= 2; }), "axes");
  EXPECT_EQ(field_of([](CameraRecord& c) { c.focal = {}; }), "focal");
  EXPECT_EQ(field_of([](CameraRecord& c) { c.focal = Fx12::from_int(kMaxFocalPx + 1); }), "focal");
  EXPECT_EQ(field_of([](CameraRecord& c) { c.near_plane = {}; }), "near_plane");
  EXPECT_EQ(field_of([](CameraRecord& c) { c.near_plane = Fx16::from_int(-1); }), "near_plane");
  EXPECT_EQ(field_of([](CameraRecord& c) { c.far_plane = c.near_plane; }), "far_plane");
}

}  // namespace
}  // namespace spanline
