#include "core/shade/light_hue.hpp"

namespace spanline {

namespace {

// All lights together.
struct Sum {
  std::uint32_t all[3] = {0, 0, 0};
  std::uint32_t brightest = 0;  // channel

  [[gnu::cold, gnu::noinline]] explicit Sum(const SceneRecord& scene) {
    for (unsigned i = 0; i < 3; ++i) {
      for (const LightRecord& light : scene.lights) all[i] += light.intensity[i];
      if (all[i] > all[brightest]) brightest = i;
    }
  }
};

}  // namespace

[[gnu::cold]] LightHue::LightHue(const SceneRecord& scene) {
  const Sum sum(scene);
  static_assert(std::uint64_t{kMaxLights} * UINT16_MAX << kBits <= UINT32_MAX, "shifted sums fit their words");
  const std::uint32_t most = sum.all[sum.brightest];
  channel_ = static_cast<std::uint8_t>(sum.brightest);
  for (int i = 0; i < 3; ++i) {
    ambient_[i] = scene.ambient[i];
    part_[i] = static_cast<std::int16_t>(most == 0 ? 0 : (sum.all[i] << kBits) / most);
  }
}

[[gnu::cold]] bool LightHue::is_one(const SceneRecord& scene) {
  const Sum sum(scene);
  const std::uint32_t most = sum.all[sum.brightest];
  // As far off as the rounding of two lights' intensities may bring a hue.
  const std::int64_t slack = 2 * std::int64_t{most};
  for (const LightRecord& light : scene.lights) {
    for (int i = 0; i < 3; ++i) {
      const std::int64_t off =
          std::int64_t{light.intensity[i]} * most - std::int64_t{light.intensity[sum.brightest]} * sum.all[i];
      if (off < -slack || off > slack) return false;
    }
  }
  return true;
}

int LightHue::channel(const SceneRecord& scene) { return static_cast<int>(Sum(scene).brightest); }

}  // namespace spanline
