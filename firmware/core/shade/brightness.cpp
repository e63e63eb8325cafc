#include "core/shade/brightness.hpp"

#include "core/shade/light_hue.hpp"
#include "core/shade/pixel.hpp"

namespace spanline {

namespace {

// Of a large or narrow cell, along its diagonals; none where it would be steep, which takes a cell of no width.
[[gnu::cold]] Gradient rare_gradient(const ScreenXY (&diagonals)[3], std::int32_t rise1, std::int32_t rise2) {
  const ExactGradient exact(diagonals, rise1, rise2);
  if (exact.area == 0) return {};
  const std::int64_t right = exact.a_pixel(exact.along_x, detail::kBrightnessBits);
  const std::int64_t down = exact.a_pixel(exact.along_y, detail::kBrightnessBits);
  const auto steep = [](std::int64_t v) { return v >= kSteepest || v <= -kSteepest; };
  if (steep(right) || steep(down)) return {};
  return {static_cast<std::int32_t>(right), static_cast<std::int32_t>(down)};
}

// How far a plane is to be moved that has `share` more than the first and third corner, and so much less than the
// others, to be in the table at all four. One that spans more than the table is made level.
[[gnu::cold]] std::uint32_t into_table(const Brightness (&corner)[4], std::int32_t share, Gradient& gradient) {
  constexpr std::int32_t kFull = std::int32_t{kFullBrightness} << detail::kBrightnessBits;
  std::int32_t least = INT32_MAX, most = INT32_MIN;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::int32_t v = corner[i] * (1 << detail::kBrightnessBits) + (i % 2 == 0 ? share : -share);
    if (v < least) least = v;
    if (v > most) most = v;
  }
  const std::int32_t first = corner[0] * (1 << detail::kBrightnessBits) + share;
  if (most - least > kFull) {
    gradient = {};
    return static_cast<std::uint32_t>(kFull / 2 - first);
  }
  return static_cast<std::uint32_t>(least < 0 ? -least : most > kFull ? kFull - most : 0);
}

}  // namespace

BrightnessPlane cell_brightness(const ScreenXY (&at)[4], const Brightness (&corner)[4]) {
  using detail::kBrightnessBits;
  constexpr int kToPlane = BrightnessPlane::kFraction - kBrightnessStep - kBrightnessBits;
  const auto difference = [](ScreenXY a, ScreenXY b) {  // of points in the view
    return ScreenXY{static_cast<std::int16_t>(b.x - a.x), static_cast<std::int16_t>(b.y - a.y)};
  };
  const ScreenXY diagonals[3] = {{}, difference(at[0], at[2]), difference(at[1], at[3])};
  const std::int32_t rise1 = corner[2] - corner[0], rise2 = corner[3] - corner[1];
  Gradient gradient;
  if (!small_gradient<kFullBrightness>(diagonals, rise1, rise2, kBrightnessBits, gradient)) [[unlikely]] {
    gradient = rare_gradient(diagonals, rise1, rise2);
  }
  // What the plane through the first and third corner has too little at the second, half of which all four share.
  // Within the cell the plane spans less than twice what brightness does, so this fits, whatever its terms are.
  const ScreenXY side = difference(at[0], at[1]);
  const auto product = [](std::int32_t a, std::int32_t b) {
    return static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
  };
  const auto rise = static_cast<std::uint32_t>(corner[1] - corner[0]) << (kBrightnessBits + 4);
  const std::uint32_t lack = rise - product(gradient.right, side.x) - product(gradient.down, side.y);
  static_assert(std::int64_t{4} * kFullBrightness << (kBrightnessBits + 4) <= INT32_MAX);
  const std::int32_t share = static_cast<std::int32_t>(lack) >> 5;
  std::uint32_t start = (std::uint32_t{corner[0]} << kBrightnessBits) + static_cast<std::uint32_t>(share);
  constexpr std::int32_t kLittle = 1 << kBrightnessBits;  // half of what is beyond either end of the table
  static_assert(2 * kLittle == 1 << (kBrightnessBits + kBrightnessStep - 1));
  if (share > kLittle || share < -kLittle) [[unlikely]] {
    start += into_table(corner, share, gradient);
  }
  const std::uint32_t half_entry = 1u << (kBrightnessStep + kBrightnessBits - 1);
  return {at_origin(start + half_entry, at[0], gradient) << kToPlane,
          static_cast<std::uint32_t>(gradient.right) << kToPlane,
          static_cast<std::uint32_t>(gradient.down) << kToPlane};
}

[[gnu::cold]] void SmoothCache::clear() {
  if (!on()) return;
  for (std::uint32_t i = 0; i <= looks_.capacity(); ++i) looks_[i].face = 0;
  oldest_ = 0;
  for (std::uint32_t i = 0; i <= table_mask_; ++i) tables_[i].material = FaceLook::kNoMaterial;
}

namespace {

// How bright an entry of the table is: Q8.8, as LightRig sums light.
constexpr std::uint32_t light_of_entry(std::uint32_t entry) {
  constexpr std::uint32_t kLast = ColorTable::kEntries - 1;
  return (entry * 256 + kLast / 2) / kLast;
}

}  // namespace

[[gnu::cold]] void SmoothCache::fill_plain(ColorTable& table, std::uint16_t material, const SceneRecord& scene) {
  table.material = material;
  for (std::uint32_t i = 0; i < ColorTable::kEntries; ++i) {
    table.colors[i] = lit_rgb565_wire(scene.materials[material].color, light_of_entry(i));
  }
}

void SmoothCache::fill(ColorTable& table, std::uint16_t material, const SceneRecord& scene) {
  const Rgb8 color = scene.materials[material].color;
  const LightHue hue(scene);
  table.material = material;
  for (std::uint32_t i = 0; i < ColorTable::kEntries; ++i) {
    const std::uint32_t bright = light_of_entry(i);
    const auto lit = [&hue, bright](std::uint32_t channel, int number) {
      const std::uint32_t v = (channel * hue.in(number, bright) + 128) >> 8;
      return static_cast<std::uint8_t>(v < 255 ? v : 255);
    };
    table.colors[i] = flat_payload(format_, {lit(color.r, 0), lit(color.g, 1), lit(color.b, 2)});
  }
}

}  // namespace spanline
