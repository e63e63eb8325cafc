#include "core/shade/brightness.hpp"

#include "core/geom/gradient.hpp"
#include "core/shade/pixel.hpp"

namespace spanline {

namespace {

// Gradients are made with fewer bits than the plane has, which leaves room for the steps of slivers.
constexpr int kBits = 16;
constexpr int kToPlane = BrightnessPlane::kFraction - kBrightnessStep - kBits;
static_assert(kToPlane > 0, "no plane is odd: FaceLook::kFlat");

// By exact divisions, for large and steep triangles.
Gradient exact_gradient(const ScreenXY (&at)[3], std::int64_t rise1, std::int64_t rise2) {
  const std::int64_t dx1 = at[1].x - at[0].x, dx2 = at[2].x - at[0].x;
  const std::int64_t dy1 = at[1].y - at[0].y, dy2 = at[2].y - at[0].y;
  const std::int64_t area = dx1 * dy2 - dx2 * dy1;
  if (area == 0) return {0, 0};  // covers no pixel
  const std::int64_t scale = (area < 0 ? -1 : 1) * (std::int64_t{kSubpixels} << kBits);
  const std::int64_t divisor = area < 0 ? -area : area;
  // Rises are below 2^8, distances up to 2^16: below 2^46.
  return {round_div((rise1 * dy2 - rise2 * dy1) * scale, divisor),
          round_div((rise2 * dx1 - rise1 * dx2) * scale, divisor)};
}

}  // namespace

BrightnessPlane brightness_plane(const ScreenXY (&at)[3], const Brightness (&corner)[3]) {
  const std::int32_t rise1 = corner[1] - corner[0], rise2 = corner[2] - corner[0];
  Gradient gradient;
  if (!small_gradient<kBits, kFullBrightness>(at, rise1, rise2, gradient)) gradient = exact_gradient(at, rise1, rise2);
  const std::uint32_t half = 1u << (kBrightnessStep + kBits - 1);
  const std::uint32_t start = (std::uint32_t{corner[0]} << kBits) + half;
  return {at_origin(start, at[0], gradient) << kToPlane, static_cast<std::uint32_t>(gradient.right) << kToPlane,
          static_cast<std::uint32_t>(gradient.down) << kToPlane};
}

void SmoothCache::clear() {
  for (std::uint32_t i = 0; on() && i <= looks_.capacity(); ++i) looks_[i].face = 0;
  oldest_ = 0;
  for (std::uint32_t i = 0; on() && i <= table_mask_; ++i) tables_[i].material = 0xffff;
}

void SmoothCache::fill(ColorTable& table, std::uint16_t material, const Rgb8& color) {
  table.material = material;
  constexpr std::uint32_t kLast = ColorTable::kEntries - 1;
  for (std::uint32_t i = 0; i <= kLast; ++i) {
    const std::uint32_t bright = (i * 256 + kLast / 2) / kLast;  // Q8.8, as LightRig sums light
    const auto lit = [bright](std::uint32_t channel) {
      return static_cast<std::uint8_t>((channel * bright + 128) >> 8);
    };
    table.colors[i] = flat_payload(format_, {lit(color.r), lit(color.g), lit(color.b)});
  }
}

}  // namespace spanline
