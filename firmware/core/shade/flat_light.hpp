#pragma once

#include "core/shade/light.hpp"
#include "core/shade/pixel.hpp"

namespace spanline {

// A material's flat colours in an instance's light; both, and the rig, must outlive it.
class FlatLight {
 public:
  FlatLight(const LightRig& rig, const MaterialRecord& material, PixelFormat format)
      : rig_(rig), material_(material), format_(format) {
    quick_ = rig.quick() && format == PixelFormat::rgb565 && material.shading != MaterialRecord::kUnlit &&
             material.reach == MaterialRecord::kAllLight;
    if (quick_) one_ = rig.one();
  }

  // Of a surface with this normal, as flat_payload() has it; `flip`: of its back.
  std::uint16_t payload(const Normal10& normal, bool flip) const {
    if (quick_ && !flip) return lit_rgb565_wire(material_.color, one_.sum(normal));
    return flat_payload(format_, rig_.shade(normal, material_, flip));
  }

 private:
  const LightRig& rig_;
  const MaterialRecord& material_;
  LightRig::One one_{};
  PixelFormat format_;
  bool quick_;  // one light without a hue, and it does not saturate
};

}  // namespace spanline
