#include "core/shade/facet_light.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracle/random.hpp"

namespace spanline {
namespace {

struct Vec {
  double x, y, z;
};
Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }

struct Dice : oracle::Random {
  using Random::Random;
  double in(double low, double high) { return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53; }
  Vec direction() {
    for (;;) {
      const Vec v{in(-1, 1), in(-1, 1), in(-1, 1)};
      if (dot(v, v) > 0.01 && dot(v, v) < 1) return unit(v);
    }
  }
  // Three at right angles that turn like x, y and z.
  void axes(Vec (&out)[3]) {
    out[0] = direction();
    out[1] = unit(cross(direction(), out[0]));
    out[2] = cross(out[0], out[1]);
  }
};

// An instance that is turned, scaled evenly and perhaps mirrored, in the light of one lamp, and a camera.
struct Stage {
  static constexpr double kAmbient = 0.25, kIntensity = 0.75;

  bool mirrored;
  double focal;   // guard bands
  Vec camera[3];  // right, down, ahead
  Vec toward;     // the lamp
  LightRecord lamp;
  SceneRecord scene{};
  Transform transform = Transform::identity();
  ClipMatrix matrix{};

  explicit Stage(Dice& random)
      : mirrored(random.next() % 4 == 0), focal(random.in(0.1, 3)), toward(random.direction()) {
    Vec mesh[3];  // where the mesh's axes point, in the world
    random.axes(camera);
    random.axes(mesh);
    if (mirrored) mesh[2] = mesh[2] * -1;
    const double scale = random.in(0.05, 20);
    for (int j = 0; j < 3; ++j) {
      const double world[3] = {mesh[j].x, mesh[j].y, mesh[j].z};
      for (int i = 0; i < 3; ++i) {
        transform.matrix[i][j].raw = static_cast<std::int32_t>(std::lround(world[i] * scale * 65536));
        matrix.linear[i][j] =
            static_cast<std::int32_t>(std::lround(dot(camera[i], mesh[j]) * (i < 2 ? focal : 1) * scale * 0x1p16));
      }
    }
    const double from[3] = {-toward.x, -toward.y, -toward.z};
    for (int k = 0; k < 3; ++k) {
      lamp.direction[k].raw = static_cast<std::int32_t>(std::lround(from[k] * Fx30::kOne));
      lamp.intensity[k] = static_cast<std::uint16_t>(kIntensity * 256);
      scene.ambient[k] = static_cast<std::uint16_t>(kAmbient * 256);
    }
    scene.lights = {&lamp, 1};
  }
  Stage(const Stage&) = delete;

  ClipPoint clip(Vec world) const {
    const auto units = [](double v) { return static_cast<std::int32_t>(std::lround(v * 65536)); };
    return {units(dot(camera[0], world) * focal), units(dot(camera[1], world) * focal), units(dot(camera[2], world))};
  }
  // Of 256, for the normal of corners as they are in clip space.
  double level(const ClipPoint (&p)[4], bool flip) const {
    const auto between = [&](const ClipPoint& a, const ClipPoint& b) {
      const auto along = [](std::int32_t from, std::int32_t to) { return static_cast<double>(to) - from; };
      const Vec right = camera[0] * (along(a.x, b.x) / focal), down = camera[1] * (along(a.y, b.y) / focal),
                ahead = camera[2] * along(a.w, b.w);
      return Vec{right.x + down.x + ahead.x, right.y + down.y + ahead.y, right.z + down.z + ahead.z};
    };
    const Vec normal = unit(cross(between(p[0], p[2]), between(p[1], p[3])));
    const double facing = dot(normal, toward) * (mirrored != flip ? -1 : 1);
    return 256 * (kAmbient + kIntensity * std::max(0.0, facing));
  }
};

TEST(FacetLight, IsWithinALevelOf256OfTheExactOne) {
  Dice random(1);
  double worst = 0, square = 0, count = 0;
  for (int i = 0; i < 400; ++i) {
    const Stage stage(random);
    const LightRig rig(stage.scene, stage.transform);
    ASSERT_TRUE(rig.quick());
    const FacetLight light(rig, stage.matrix, stage.mirrored);
    for (int j = 0; j < 200; ++j) {
      // About a parallelogram, from a hundredth of a unit to a unit, and not too narrow.
      const Vec u = random.direction(), v = random.direction();
      const double along = std::exp(random.in(std::log(0.01), 0)), across = along * random.in(0.2, 1);
      if (std::abs(dot(u, v)) > 0.95) continue;
      const Vec at = random.direction() * 20;
      const auto corner = [&](double s, double t) {
        return stage.clip({at.x + u.x * along * s + v.x * across * t, at.y + u.y * along * s + v.y * across * t,
                           at.z + u.z * along * s + v.z * across * t});
      };
      const ClipPoint p[4] = {corner(0, 0), corner(1, 0.1), corner(0.9, 1), corner(0, 1)};
      const bool flip = random.next() % 2 == 0;
      std::uint32_t sum = 0;
      ASSERT_TRUE(light.sum(p[0], p[1], p[2], p[3], flip, sum));
      const double off = sum - stage.level(p, flip);
      worst = std::max(worst, std::abs(off));
      square += off * off;
      ++count;
    }
  }
  EXPECT_LT(worst, 1);
  EXPECT_LT(std::sqrt(square / count), 0.3);
}

// Where it does not know, the normal is taken back to the mesh.
TEST(FacetLight, IsTheRigsWhereDiagonalsSpanNothing) {
  Dice random(2);
  const Stage stage(random);
  const LightRig rig(stage.scene, stage.transform);
  const FacetLight light(rig, stage.matrix, stage.mirrored);
  const MaterialRecord material{{200, 100, 50}, MaterialRecord::kFlat};
  const FacetLight::Of of(light, material, PixelFormat::rgb565, true);
  const ClipPoint p{100, 200, 300}, q{400, 200, 300};
  const Rgb8 color = rig.shade(Normal10::pack(0, 0, 511), material, false);
  EXPECT_EQ(of.payload(p, q, p, q, false), flat_payload(PixelFormat::rgb565, color));
}

}  // namespace
}  // namespace spanline
