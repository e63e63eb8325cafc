// The light on the facets of patches, by their corners in clip space.
#pragma once

#include <cstdint>

#include "core/curve/normals.hpp"
#include "core/fx/inverse_root.hpp"
#include "core/shade/light.hpp"
#include "core/shade/pixel.hpp"

namespace spanline {

// The lights of an instance as its facets see them in clip space. A facet's normal there is n, what its diagonals span;
// in the mesh it is the matrix's transpose times n. So its product with a light is that of n with the matrix times the
// light; and the matrix's rows stand upright on one another where the transform only turns and scales evenly, so that
// its length is that of n's components times theirs. No normal is taken back to the mesh then, nor made a unit.
class FacetLight {
 public:
  FacetLight() = default;
  // Of the instance that `reader` is at; `rig` must outlive it.
  FacetLight(const LightRig& rig, const ClipMatrix& matrix, bool mirrored);

  // How much light falls on it, Q8.8, where the rig is quick(). False where its diagonals span nothing.
  [[gnu::always_inline]] bool sum(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c, const ClipPoint& d,
                                  bool flip, std::uint32_t& out) const;

  // Facets of one material.
  class Of {
   public:
    // `near`: no corners differ by 2^31 and more.
    Of(const FacetLight& light, const MaterialRecord& material, PixelFormat format, bool near)
        : light_(light),
          material_(material),
          format_(format),
          quick_(light.quick_ && near && format == PixelFormat::rgb565 && material.shading != MaterialRecord::kUnlit &&
                 material.reach == MaterialRecord::kAllLight) {}

    // The colour of the facet with these corners, in order, as flat_payload() has it; `flip`: of its back. kQuick:
    // where quick(), as it is found out inside.
    bool quick() const { return quick_; }
    template <bool kQuick = false>
    [[gnu::always_inline]] std::uint16_t payload(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c,
                                                 const ClipPoint& d, bool flip) const {
      std::uint32_t sum = 0;
      if ((kQuick || quick_) && light_.sum(a, b, c, d, flip, sum)) [[likely]]
        return lit_rgb565_wire(material_.color, sum);
      return exact(a, b, c, d, flip);
    }

   private:
    [[gnu::noinline]] std::uint16_t exact(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c,
                                          const ClipPoint& d, bool flip) const {
      return flat_payload(format_, light_.rig_->shade(light_.normals_.of(a, b, c, d), material_, flip));
    }

    const FacetLight& light_;
    const MaterialRecord& material_;
    PixelFormat format_;
    bool quick_;
  };

 private:
  const LightRig* rig_ = nullptr;
  FacetNormals normals_;
  std::int32_t toward_[3];  // the matrix times what leads to the light, below 2^14
  std::int32_t length_[3];  // of the matrix's rows, likewise
  std::uint32_t intensity_ = 0, ambient_ = 0;
  bool quick_ = false;  // LightRig::quick()
};

inline bool FacetLight::sum(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c, const ClipPoint& d, bool flip,
                            std::uint32_t& out) const {
  const auto between = [](const ClipPoint& from, const ClipPoint& to) {
    return ShortVector{{to.x - from.x, to.y - from.y, to.w - from.w}};
  };
  const ShortVector n = ShortVector::spanned(between(a, c), between(b, d));
  // Of 14 bits and a sign, as is what they are multiplied with: so the sum of squares fits 32 bits.
  const auto scaled = [&](int i) { return n.v[i] * length_[i] >> 13; };
  const std::int32_t x = scaled(0), y = scaled(1), w = scaled(2);
  const auto square = static_cast<std::uint32_t>(x * x + y * y + w * w);
  if (square == 0) return false;
  const InverseRoot inverse(square);
  const std::int32_t dot = n.v[0] * toward_[0] + n.v[1] * toward_[1] + n.v[2] * toward_[2];
  // |dot| is at most 2^13 times the length, and as the shortest ones are cut off 2.5 times that; 2^up times the length
  // is in [2^15, 2^16), and so much times the factor is 2^31.
  const std::int32_t along = (dot * (1 << inverse.up) >> 15) * static_cast<std::int32_t>(inverse.factor) >> 14;
  out = (ambient_ + saturate15(flip ? -along : along) * intensity_) >> 15;
  return true;
}

}  // namespace spanline
