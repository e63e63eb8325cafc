#include "core/shade/facet_light.hpp"

#include "core/fx/root.hpp"

namespace spanline {

[[gnu::cold]] FacetLight::FacetLight(const LightRig& rig, const ClipMatrix& matrix, bool mirrored)
    : rig_(&rig), normals_(matrix, mirrored), quick_(rig.quick()) {
  if (!quick_) return;
  const LightRig::One one = rig.one();
  intensity_ = one.intensity;
  ambient_ = one.ambient;
  for (int i = 0; i < 3; ++i) {
    const ShortVector row = normals_.row(i);
    const auto times = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
      return row.v[0] * x + row.v[1] * y + row.v[2] * z;
    };
    // Rows are up to sqrt(3) * 2^14 long, and where a light leads to is scaled by 512 / 511.
    toward_[i] = shift_round((times(one.x, one.y, one.z) >> 9) * 511, 15);
    const auto square = static_cast<std::uint32_t>(times(row.v[0], row.v[1], row.v[2]));
    length_[i] = static_cast<std::int32_t>((square_root(square) + 1) / 2);
  }
}

}  // namespace spanline
