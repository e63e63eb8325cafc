#pragma once

#include "core/scene/format.hpp"

namespace spanline {

// The light of a scene as a line in the space of colours: whatever falls on a surface is the ambient light and an
// amount of one hue, where all lights have that hue. One channel then tells the others.
class LightHue {
 public:
  // The hue is that of all lights together, told by their brightest channel; the ambient light may have another.
  explicit LightHue(const SceneRecord& scene);

  // Whether every light has the hue, as nearly as its intensities in Q8.8 can say it. So it is without lights.
  static bool is_one(const SceneRecord& scene);
  static int channel(const SceneRecord& scene);  // the one that tells
  // The light in channel `i` where channel() has `sum`, Q8.8; not below 0. Exact where nothing has a hue.
  std::uint32_t in(int i, std::uint32_t sum) const {
    const auto amount = static_cast<std::int32_t>(sum) - ambient_[channel_];
    const std::int32_t light = ambient_[i] + ((amount * part_[i] + kHalf) >> kBits);
    return light < 0 ? 0 : static_cast<std::uint32_t>(light);
  }

 private:
  static constexpr int kBits = 12;
  static constexpr std::int32_t kHalf = 1 << (kBits - 1);

  std::uint16_t ambient_[3];
  std::int16_t part_[3];  // of the hue, Q4.12: at most 1, which is channel()'s
  std::uint8_t channel_;
};

}  // namespace spanline
