#include "demos/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spanline::demos {
namespace {

constexpr Turn16 kQuarter{16384};
constexpr Fx16 kOrigin[][3] = {{{}, {}, {}}};

TEST(Motion, AQuarterTurnAboutEachAxis) {
  const std::int32_t one = Fx16::kOne;
  const std::int32_t expected[3][3][3] = {{{one, 0, 0}, {0, 0, -one}, {0, one, 0}},
                                          {{0, 0, one}, {0, one, 0}, {-one, 0, 0}},
                                          {{0, -one, 0}, {one, 0, 0}, {0, 0, one}}};
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    InstanceRecord instance{};
    spin(instance, kOrigin, axis, kQuarter);
    for (unsigned row = 0; row < 3; ++row) {
      for (unsigned column = 0; column < 3; ++column) {
        EXPECT_EQ(instance.transform.matrix[row][column].raw, expected[static_cast<unsigned>(axis)][row][column]);
      }
    }
  }
}

// The world position of a point of the mesh, Q16.16.
std::array<double, 3> placed(const Transform& t, const Fx16 (&point)[3]) {
  std::array<double, 3> out{};
  for (unsigned i = 0; i < 3; ++i) {
    out[i] = t.translation[i].raw;
    for (unsigned k = 0; k < 3; ++k) out[i] += std::ldexp(double(t.matrix[i][k].raw) * point[k].raw, -16);
  }
  return out;
}

TEST(Motion, TheOriginStaysWhereItIs) {
  const Fx16 origins[][3] = {{Fx16::from_int(-300), Fx16::from_int(70), Fx16::from_int(2000)}};
  for (unsigned step = 0; step < 64; ++step) {
    InstanceRecord instance{};
    instance.transform.translation[1] = Fx16::from_int(17);
    const auto before = placed(instance.transform, origins[0]);
    spin(instance, origins, static_cast<Axis>(step % 3), {static_cast<std::uint16_t>(step * 1021)});
    const auto after = placed(instance.transform, origins[0]);
    for (unsigned i = 0; i < 3; ++i) EXPECT_NEAR(after[i], before[i], 2) << step;
  }
}

TEST(Motion, AnglesRepeatExactly) {
  EXPECT_EQ(part_of_turn(0, 3, 600).raw, 0);
  EXPECT_EQ(part_of_turn(200, 3, 600).raw, 0);
  EXPECT_EQ(part_of_turn(50, 1, 200).raw, kQuarter.raw);
  EXPECT_EQ(part_of_turn(4294967295u, 3, 600).raw, part_of_turn(4294967295u % 600, 3, 600).raw);
}

TEST(Motion, SwingIsASine) {
  constexpr Turn16 kAmplitude{20000};
  EXPECT_EQ(swing(kAmplitude, {0}).raw, 0);
  EXPECT_EQ(swing(kAmplitude, kQuarter).raw, 20000);
  EXPECT_EQ(swing(kAmplitude, kQuarter + kQuarter + kQuarter).raw, 65536 - 20000);
  EXPECT_NEAR(swing(kAmplitude, {5461}).raw, 20000 * std::sin(5461 * std::numbers::pi / 32768), 1);
}

TEST(Motion, AnOrbitKeepsItsDistanceAndLooksAtTheTarget) {
  const Fx16 target[3] = {Fx16::from_int(10), Fx16::from_int(20), Fx16::from_int(30)};
  CameraRecord camera{};
  camera.eye[0] = Fx16::from_int(10);
  camera.eye[1] = Fx16::from_int(420);
  camera.eye[2] = Fx16::from_int(1030);
  camera.focal = Fx12::from_int(300);
  camera.near_plane = Fx16::from_int(10);
  camera.far_plane = Fx16::from_int(4000);
  orbit(camera, target, kQuarter);
  EXPECT_EQ(camera.eye[0].raw, Fx16::from_int(1010).raw);
  EXPECT_EQ(camera.eye[1].raw, Fx16::from_int(420).raw);
  EXPECT_EQ(camera.eye[2].raw, Fx16::from_int(30).raw);
  const double back = std::ldexp(camera.axes[2][0].raw, -30);
  EXPECT_NEAR(back, 1000 / std::hypot(1000, 400), 1e-6);
}

}  // namespace
}  // namespace spanline::demos
