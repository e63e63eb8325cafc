#include "core/shade/light_hue.hpp"

namespace spanline {

[[gnu::cold]] LightHue::LightHue(const SceneRecord& scene) {
  std::uint32_t all[3] = {0, 0, 0};
  for (const LightRecord& light : scene.lights) {
    for (int i = 0; i < 3; ++i) all[i] += light.intensity[i];
  }
  static_assert(std::uint64_t{kMaxLights} * UINT16_MAX << kBits <= UINT32_MAX, "shifted sums fit their words");
  for (int i = 1; i < 3; ++i) {
    if (all[i] > all[channel_]) channel_ = static_cast<std::int8_t>(i);
  }
  const std::uint32_t most = all[channel_];
  for (int i = 0; i < 3; ++i) {
    ambient_[i] = scene.ambient[i];
    part_[i] = static_cast<std::int16_t>(most == 0 ? 0 : (all[i] << kBits) / most);
    // As far off as the rounding of two lights' intensities may bring a hue.
    for (const LightRecord& light : scene.lights) {
      const std::int64_t off =
          std::int64_t{light.intensity[i]} * most - std::int64_t{light.intensity[channel_]} * all[i];
      one_ = one_ && (off < 0 ? -off : off) <= 2 * std::int64_t{most};
    }
  }
}

}  // namespace spanline
