#include "core/shade/light.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spanline {
namespace {

constexpr MaterialRecord kWhite{{255, 255, 255}, MaterialRecord::kFlat};

Fx16 fx(double v) { return Fx16::from_raw(static_cast<std::int32_t>(std::lround(v * 65536))); }

struct Vec {
  double x, y, z;
  double length() const { return std::sqrt(x * x + y * y + z * z); }
};

Normal10 packed(Vec n) {
  const auto q = [&](double v) { return static_cast<int>(std::lround(v / n.length() * 511)); };
  return Normal10::pack(q(n.x), q(n.y), q(n.z));
}

struct Rig {
  LightRecord light[kMaxLights];
  SceneRecord scene{};

  Rig(std::uint32_t lights, double ambient) {
    scene.lights = {light, lights};
    for (auto& a : scene.ambient) a = static_cast<std::uint16_t>(ambient * 256);
  }
  void aim(int i, Vec d, double intensity) {
    const double v[3] = {d.x, d.y, d.z};
    for (int k = 0; k < 3; ++k) {
      light[i].direction[k].raw = static_cast<std::int32_t>(std::lround(v[k] / d.length() * Fx30::kOne));
      light[i].intensity[k] = static_cast<std::uint16_t>(intensity * 256);
    }
  }
};

Transform linear(const double (&m)[3][3]) {
  Transform t = Transform::identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.matrix[i][j] = fx(m[i][j]);
  }
  return t;
}

// The brightness of the normal n of a mesh under a transform, in doubles: the normal goes with the cofactors.
double exact(const double (&m)[3][3], Vec n, Vec light, double ambient, double diffuse) {
  const auto cofactor = [&](int i, int j) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  const double sign = determinant < 0 ? -1 : 1;
  const Vec w{sign * (cofactor(0, 0) * n.x + cofactor(0, 1) * n.y + cofactor(0, 2) * n.z),
              sign * (cofactor(1, 0) * n.x + cofactor(1, 1) * n.y + cofactor(1, 2) * n.z),
              sign * (cofactor(2, 0) * n.x + cofactor(2, 1) * n.y + cofactor(2, 2) * n.z)};
  const double dot = -(light.x * w.x + light.y * w.y + light.z * w.z) / (w.length() * light.length());
  return std::min(255.0, 255 * (ambient + diffuse * std::max(0.0, dot)));
}

constexpr double kTransforms[][3][3] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},           {{0, -3, 0}, {3, 0, 0}, {0, 0, 3}},  // turned, three times as large
    {{0.02, 0, 0}, {0, 0.02, 0}, {0, 0, -0.02}},                                      // tiny and mirrored
    {{2, 0, 0}, {0, 0.5, 0}, {0, 0, 1}},                                              // squeezed
    {{1, 0.7, 0}, {0, 1, -0.4}, {0.2, 0, 1.5}},                                       // sheared
    {{-200, 0, 0}, {0, 90, 10}, {0, 0, 140}},                                         // large, uneven and mirrored
};
constexpr Vec kNormals[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 2, 3}, {-3, 1, 0.5}, {0.3, -2, -1}};

TEST(LightRig, LightsNormalsWhereTheTransformTakesThem) {
  const Vec light{-0.4, -0.8, -0.5};
  for (const auto& m : kTransforms) {
    Rig rig(1, 0.25);
    rig.aim(0, light, 0.75);
    const LightRig lights(rig.scene, linear(m));
    for (const Vec& n : kNormals) {
      const Rgb8 color = lights.shade(packed(n), kWhite, false);
      EXPECT_NEAR(color.r, exact(m, n, light, 0.25, 0.75), 3) << m[0][0] << ": " << n.x << ' ' << n.y << ' ' << n.z;
      EXPECT_EQ(color.r, color.b);
      const Vec back{-n.x, -n.y, -n.z};
      EXPECT_NEAR(lights.shade(packed(n), kWhite, true).g, exact(m, back, light, 0.25, 0.75), 3);
    }
  }
}

TEST(LightRig, AddsFourLightsAndSaturates) {
  Rig rig(4, 0.125);
  for (int i = 0; i < 4; ++i) rig.aim(i, {0, 0, -1}, 0.125 * (i + 1));
  const LightRig lights(rig.scene, Transform::identity());
  EXPECT_EQ(lights.shade(packed({0, 0, -1}), kWhite, false).r, 32);
  EXPECT_EQ(lights.shade(packed({0, 0, 1}), kWhite, false).r, 255);
  EXPECT_NEAR(lights.shade(packed({0, 0, 1}), {{100, 50, 0}, MaterialRecord::kFlat}, false).r, 137, 1);
}

TEST(LightRig, LightsAreColoured) {
  Rig rig(1, 0);
  rig.aim(0, {0, -1, 0}, 1);
  rig.light[0].intensity[1] = 128;
  rig.light[0].intensity[2] = 0;
  const Rgb8 color = LightRig(rig.scene, Transform::identity()).shade(packed({0, 1, 0}), kWhite, false);
  EXPECT_EQ(color, (Rgb8{255, 128, 0}));
}

TEST(LightRig, LeavesUnlitMaterialsAlone) {
  Rig rig(0, 0);
  const MaterialRecord unlit{{9, 8, 7}, MaterialRecord::kUnlit};
  EXPECT_EQ(LightRig(rig.scene, Transform::identity()).shade(packed({0, 1, 0}), unlit, false), (Rgb8{9, 8, 7}));
}

TEST(LightRig, ACollapsedTransformIsAmbientOnly) {
  Rig rig(1, 0.5);
  rig.aim(0, {0, -1, 0}, 0.5);
  const Transform nothing{};
  EXPECT_EQ(LightRig(rig.scene, nothing).shade(packed({0, 1, 0}), kWhite, false).r, 128);
}

}  // namespace
}  // namespace spanline
