#include "core/curve/dice_view.hpp"

#include <bit>

#include "core/fx/length.hpp"

namespace spanline {

ScreenXY place_on_screen(const ClipPoint& p, const DiceView& view) {
  if (p.w < view.near_w || p.w <= 0) return kNotProjected;
  const auto w = static_cast<std::uint32_t>(p.w);
  const int up = std::countl_zero(w) - 1;
  const auto inverse = static_cast<std::int32_t>(reciprocal_normalised(w << up));  // of 2^61
  const auto place = [&](std::int32_t v, std::int32_t centre) {
    constexpr std::int32_t kBorder = 1 << kProjectedBits;
    const std::int32_t off = magnitude(v) >= w ? (v < 0 ? -kBorder : kBorder)
                                               : shift_round(mul_high(v * (1 << up), inverse), 29 - kProjectedBits);
    return static_cast<std::int16_t>(centre + off);
  };
  return {place(p.x, view.centre_x), place(p.y, view.centre_y)};
}

}  // namespace spanline
