// Planes over the screen: the gradients of what three points have.
#pragma once

#include <bit>
#include <cstdint>

#include "core/fx/bits.hpp"
#include "core/fx/reciprocal.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

// Of a value over the screen: how it grows a pixel to the right and a line down.
struct Gradient {
  std::int64_t right, down;
};

inline constexpr std::int32_t kSteepest = 1 << 29;

// The gradient of a triangle of less than 256 pixels each way, where it is not steep, by one reciprocal: off by less
// than 2^-27 of itself. `rise`: the second and third corner's values less the first's, kRise at most; the result has
// kBits fraction bits more. False where the triangle is no such.
template <int kBits, std::int32_t kRise>
inline bool small_gradient(const ScreenXY (&at)[3], std::int32_t rise1, std::int32_t rise2, Gradient& out) {
  const auto fits = [](std::int64_t v, std::int32_t limit) { return v > -limit && v < limit; };
  const std::int32_t dx1 = at[1].x - at[0].x, dx2 = at[2].x - at[0].x;
  const std::int32_t dy1 = at[1].y - at[0].y, dy2 = at[2].y - at[0].y;
  constexpr std::int32_t kSmall = 256 * kSubpixels;
  if (!fits(dx1, kSmall) || !fits(dx2, kSmall) || !fits(dy1, kSmall) || !fits(dy2, kSmall)) return false;
  std::int32_t area = dx1 * dy2 - dx2 * dy1;
  if (area == 0) return false;
  if (area < 0) {  // the other way round
    area = -area;
    rise1 = -rise1;
    rise2 = -rise2;
  }
  std::int32_t along_x, along_y;
  if constexpr (kRise <= 1 << 18) {
    along_x = rise1 * dy2 - rise2 * dy1;
    along_y = rise2 * dx1 - rise1 * dx2;
  } else {
    const std::int64_t x = std::int64_t{rise1} * dy2 - std::int64_t{rise2} * dy1;
    const std::int64_t y = std::int64_t{rise2} * dx1 - std::int64_t{rise1} * dx2;
    if (!fits(x, INT32_MAX) || !fits(y, INT32_MAX)) return false;
    along_x = static_cast<std::int32_t>(x);
    along_y = static_cast<std::int32_t>(y);
  }
  // along / area * 2^(kBits + 4), where 1 / area = inverse * 2^up / 2^61.
  const int up = std::countl_zero(static_cast<std::uint32_t>(area)) - 1;
  const auto inverse = static_cast<std::int32_t>(reciprocal_normalised(static_cast<std::uint32_t>(area) << up));
  const int down = 61 - 4 - kBits - up;
  const std::int64_t half = std::int64_t{1} << (down - 1);
  const std::int64_t x = std::int64_t{along_x} * inverse + half, y = std::int64_t{along_y} * inverse + half;
  if (down < 32) {
    // Both halves of the sum by themselves: a shift of 64 bits would ask again on which side of 32 it is.
    const auto high_x = static_cast<std::int32_t>(x >> 32), high_y = static_cast<std::int32_t>(y >> 32);
    const std::int32_t limit = kSteepest >> (32 - down);
    if (high_x >= limit || high_x < -limit || high_y >= limit || high_y < -limit) return false;
    out.right = static_cast<std::int32_t>(static_cast<std::uint32_t>(x) >> down | static_cast<std::uint32_t>(high_x)
                                                                                      << (32 - down));
    out.down = static_cast<std::int32_t>(static_cast<std::uint32_t>(y) >> down | static_cast<std::uint32_t>(high_y)
                                                                                     << (32 - down));
    return true;
  }
  out.right = x >> down;
  out.down = y >> down;
  return fits(out.right, kSteepest) && fits(out.down, kSteepest);
}

// What a value of `from` at a point is at the centre of column 0 and line 0, modulo 2^32.
inline std::uint32_t at_origin(std::uint32_t from, ScreenXY point, const Gradient& gradient) {
  constexpr std::int32_t kCentre = kSubpixels / 2;
  const std::int64_t climb = gradient.right * (kCentre - point.x) + gradient.down * (kCentre - point.y);
  return from + static_cast<std::uint32_t>(climb >> 4);
}

}  // namespace spanline
