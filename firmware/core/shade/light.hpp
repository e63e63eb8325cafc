#pragma once

#include <cstdint>

#include "core/scene/format.hpp"
#include "core/shade/brightness.hpp"

namespace spanline {

// The lights as one instance's mesh sees them, so that a normal is lit where it lies: ambient plus up to four
// directional lights, each intensity * max(0, -direction . normal), a channel at a time, saturating at 255.
class LightRig {
 public:
  LightRig() = default;
  LightRig(const SceneRecord& scene, const Transform& transform);

  // The colour of a surface with this normal and material; `flip` turns the normal round (a back seen from behind).
  Rgb8 shade(const Normal10& normal, const MaterialRecord& material, bool flip) const;

  // Whether ambient and lights have no hue, so that brightness is one number.
  bool grey() const { return grey_; }
  // How bright a surface with this normal is then.
  Brightness brightness(const Normal10& normal, bool flip) const {
    const std::uint32_t sum = grey_sum(normal, flip);
    return static_cast<Brightness>(((sum < 256 ? sum : 256) * kFullBrightness + 128) >> 8);
  }

  // shade() where grey() and the material is lit.
  Rgb8 grey_shade(const Normal10& normal, const Rgb8& color, bool flip) const {
    const std::uint32_t sum = grey_sum(normal, flip);
    if (sum > 256) return saturated(color, sum);
    const auto lit = [sum](std::uint32_t channel) { return static_cast<std::uint8_t>((channel * sum + 128) >> 8); };
    return {lit(color.r), lit(color.g), lit(color.b)};
  }

 private:
  static Rgb8 saturated(const Rgb8& color, std::uint32_t sum);
  // Q8.8, of any channel.
  std::uint32_t grey_sum(const Normal10& normal, bool flip) const {
    if (count_ != 1 || !uniform_ || flip) return grey_sum_of_all(normal, flip);
    const std::int16_t(&d)[3] = direction_[0];
    const std::int32_t dot = -(d[0] * normal.x() + d[1] * normal.y() + d[2] * normal.z()) >> 8;
    if (dot <= 0) return ambient_[0];
    const auto amount = static_cast<std::uint32_t>(dot < 32768 ? dot : 32768);  // Q1.15
    return ambient_[0] + ((amount * intensity_[0][0] + (1u << 14)) >> 15);
  }
  std::uint32_t grey_sum_of_all(const Normal10& normal, bool flip) const;
  std::int32_t diffuse(unsigned light, const Normal10& normal, bool flip, std::uint32_t length) const;
  std::uint32_t turned_length(const Normal10& normal) const;

  std::uint32_t count_ = 0;
  bool grey_ = true;  // ambient and lights have no hue
  Slice<const ReachRecord> reaches_;
  bool uniform_ = true;                    // the transform only turns and scales evenly
  std::int16_t direction_[kMaxLights][3];  // in the mesh, Q2.14; scaled by 512 / 511 for Normal10's unit
  std::int16_t normal_matrix_[3][3];       // cofactors, common scale; where not uniform
  std::uint16_t intensity_[kMaxLights][3];
  std::uint16_t ambient_[3] = {0, 0, 0};
};

}  // namespace spanline
