#include "core/shade/brightness.hpp"

#include "core/fx/rare_div.hpp"
#include "core/shade/light_hue.hpp"
#include "core/shade/pixel.hpp"

namespace spanline {

BrightnessPlane detail::exact_brightness(const ScreenXY (&at)[3], std::uint32_t start, std::int32_t rise1,
                                         std::int32_t rise2) {
  const std::int64_t dx1 = at[1].x - at[0].x, dx2 = at[2].x - at[0].x;
  const std::int64_t dy1 = at[1].y - at[0].y, dy2 = at[2].y - at[0].y;
  const std::int64_t area = dx1 * dy2 - dx2 * dy1;
  if (area == 0) return {start, 0, 0};  // covers no pixel
  const std::int64_t scale = (area < 0 ? -1 : 1) * (std::int64_t{kSubpixels} << kBrightnessBits);
  const std::int64_t divisor = area < 0 ? -area : area;
  // Rises are below 2^8, distances up to 2^16: below 2^46.
  const std::int64_t right = rare_round_div((rise1 * dy2 - rise2 * dy1) * scale, divisor);
  const std::int64_t down = rare_round_div((rise2 * dx1 - rise1 * dx2) * scale, divisor);
  const std::int64_t climb = right * (kSubpixels / 2 - at[0].x) + down * (kSubpixels / 2 - at[0].y);
  return {start + static_cast<std::uint32_t>(climb >> 4), static_cast<std::uint32_t>(right),
          static_cast<std::uint32_t>(down)};
}

[[gnu::cold]] void SmoothCache::clear() {
  if (!on()) return;
  for (std::uint32_t i = 0; i <= looks_.capacity(); ++i) looks_[i].face = 0;
  oldest_ = 0;
  for (std::uint32_t i = 0; i <= table_mask_; ++i) tables_[i].material = FaceLook::kNoMaterial;
}

void SmoothCache::fill(ColorTable& table, std::uint16_t material, const SceneRecord& scene) {
  const Rgb8 color = scene.materials[material].color;
  const LightHue hue(scene);
  table.material = material;
  constexpr std::uint32_t kLast = ColorTable::kEntries - 1;
  for (std::uint32_t i = 0; i <= kLast; ++i) {
    const std::uint32_t bright = (i * 256 + kLast / 2) / kLast;  // Q8.8, as LightRig sums light
    const auto lit = [&hue, bright](std::uint32_t channel, int number) {
      const std::uint32_t v = (channel * hue.in(number, bright) + 128) >> 8;
      return static_cast<std::uint8_t>(v < 255 ? v : 255);
    };
    table.colors[i] = flat_payload(format_, {lit(color.r, 0), lit(color.g, 1), lit(color.b, 2)});
  }
}

}  // namespace spanline
