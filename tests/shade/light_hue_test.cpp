// What one channel of the light says of the others, against the sums of all lights.
#include "core/shade/light_hue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/shade/light.hpp"
#include "oracle/random.hpp"

namespace spanline {
namespace {

using oracle::Random;

struct Lights {
  LightRecord light[kMaxLights]{};
  SceneRecord scene{};

  void add(const std::uint16_t (&intensity)[3]) {
    LightRecord& next = light[scene.lights.size()];
    for (int i = 0; i < 3; ++i) next.intensity[i] = intensity[i];
    scene.lights = {light, scene.lights.size() + 1};
  }
};

TEST(LightHue, GreyLightIsTheSameInEveryChannel) {
  Lights lights;
  for (std::uint16_t& channel : lights.scene.ambient) channel = 40;
  lights.add({200, 200, 200});
  lights.add({31, 31, 31});
  const LightHue hue(lights.scene);
  EXPECT_TRUE(LightHue::is_one(lights.scene));
  for (std::uint32_t sum = 0; sum <= 256; ++sum) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(hue.in(i, sum), sum);
  }
}

TEST(LightHue, IsToldByTheBrightestChannelAndWithoutLightsByAny) {
  Lights lights;
  lights.scene.ambient[0] = 90;
  EXPECT_TRUE(LightHue::is_one(lights.scene));
  EXPECT_EQ(LightHue(lights.scene).in(0, 90), 90u);
  EXPECT_EQ(LightHue(lights.scene).in(2, 90), 0u);
  lights.add({20, 180, 60});
  const LightHue hue(lights.scene);
  EXPECT_TRUE(LightHue::is_one(lights.scene));
  EXPECT_EQ(LightHue::channel(lights.scene), 1);
  EXPECT_EQ(hue.in(0, 90), 100u) << "90 of 180 is half the light";
  EXPECT_EQ(hue.in(2, 90), 30u);
}

TEST(LightHue, TwoHuesAreNotOne) {
  Lights lights;
  lights.add({230, 215, 184});
  lights.add({31, 51, 92});
  EXPECT_FALSE(LightHue::is_one(lights.scene));
  Lights near;
  near.add({230, 215, 184});
  near.add({58, 54, 40});  // 46 would be
  EXPECT_FALSE(LightHue::is_one(near.scene));
}

TEST(LightHue, OneChannelTellsTheOthersWithinTwoUnits) {
  constexpr MaterialRecord kWhite{{255, 255, 255}, MaterialRecord::kGouraud};
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    Lights lights;
    for (std::uint16_t& channel : lights.scene.ambient) channel = static_cast<std::uint16_t>(random.below(120));
    double hue[3];
    for (double& channel : hue) channel = random.below(256);
    for (int count = random.between(0, 4); count > 0; --count) {
      const double amount = random.below(101) / 200.0;
      std::uint16_t intensity[3];
      for (int i = 0; i < 3; ++i) intensity[i] = static_cast<std::uint16_t>(std::lround(amount * hue[i]));
      lights.add(intensity);
    }
    for (LightRecord& light : lights.light) {
      light.direction[random.below(3)].raw = random.percent(50) ? Fx30::kOne : -Fx30::kOne;
    }
    const LightHue told(lights.scene);
    ASSERT_TRUE(LightHue::is_one(lights.scene)) << seed;
    const LightRig rig(lights.scene, Transform::identity());
    for (int i = 0; i < 40; ++i) {
      const Normal10 normal =
          Normal10::pack(random.between(-295, 295), random.between(-295, 295), random.between(-295, 295));
      const Rgb8 lit = rig.shade(normal, kWhite, false);
      const int channel[3] = {lit.r, lit.g, lit.b};  // 255 of them are 256 of the light
      if (std::max({channel[0], channel[1], channel[2]}) == 255) continue;
      ++compared;
      const auto sum = static_cast<std::uint32_t>(std::lround(channel[LightHue::channel(lights.scene)] * 256 / 255.0));
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(told.in(k, sum), channel[k] * 256 / 255.0, 2.6) << seed;
    }
  }
  EXPECT_GT(compared, 50000);
}

}  // namespace
}  // namespace spanline
