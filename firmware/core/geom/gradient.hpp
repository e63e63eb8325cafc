// Planes over the screen: the gradients of what three points have.
#pragma once

#include <bit>
#include <cstdint>

#include "core/fx/bits.hpp"
#include "core/fx/rare_div.hpp"
#include "core/fx/reciprocal.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

// Of a value over the screen: how it grows a pixel to the right and a line down.
struct Gradient {
  std::int32_t right, down;
};

inline constexpr std::int32_t kSteepest = 1 << 26;

// The gradient of a triangle of less than 256 pixels each way, where it is not steep, by one reciprocal and products of
// 32 bits. `rise`: the second and third corner's values less the first's, below kRise. The result has `bits` fraction
// bits more, 16 at most, with which rises are below 2^18, and is below kSteepest; it is off by less than half a unit
// and 2^-25 of itself, and as if each rise were cut off to 18 bits of the greater one where that has more. False where
// the triangle is no such.
template <std::int32_t kRise>
[[gnu::always_inline]] inline bool small_gradient(const ScreenXY (&at)[3], std::int32_t rise1, std::int32_t rise2,
                                                  int bits, Gradient& out) {
  const auto fit = [](std::int32_t limit, auto... v) {  // all of them in -limit … limit - 1, which is a power of two
    return (static_cast<std::uint32_t>(v + limit) | ...) < 2 * static_cast<std::uint32_t>(limit);
  };
  const std::int32_t dx1 = at[1].x - at[0].x, dx2 = at[2].x - at[0].x;
  const std::int32_t dy1 = at[1].y - at[0].y, dy2 = at[2].y - at[0].y;
  constexpr std::int32_t kSmall = 256 * kSubpixels, kExactRise = 1 << 18;
  if (!fit(kSmall, dx1, dx2, dy1, dy2)) return false;
  static_assert(std::int64_t{2} * kSmall * kExactRise - 1 <= INT32_MAX);
  int coarse = 0;
  if constexpr (kRise > kExactRise) {
    if (bits < 16 && !fit(kExactRise, rise1, rise2)) {
      const auto either = static_cast<std::uint32_t>((rise1 ^ rise1 >> 31) | (rise2 ^ rise2 >> 31));
      coarse = static_cast<int>(std::bit_width(either)) - 18;
      rise1 >>= coarse;
      rise2 >>= coarse;
    }
  }
  std::int32_t area = dx1 * dy2 - dx2 * dy1;
  if (area == 0) return false;
  if (area < 0) {  // the other way round
    area = -area;
    rise1 = -rise1;
    rise2 = -rise2;
  }
  const std::int32_t along_x = rise1 * dy2 - rise2 * dy1;
  const std::int32_t along_y = rise2 * dx1 - rise1 * dx2;
  // along / area * 2^(bits + 4 + coarse), where 1 / area = inverse * 2^up / 2^61: `along` goes up before the product,
  // of which the high half is taken, and comes down after it. Of a gradient below kSteepest it fits if that is by 4.
  const int up = std::countl_zero(static_cast<std::uint32_t>(area)) - 1;
  const auto inverse = static_cast<std::int32_t>(reciprocal_normalised(static_cast<std::uint32_t>(area) << up));
  static_assert(kSteepest == (1 << 30) >> 4);
  constexpr int kLeastUp = 31 - (2 * 12 + 2);  // areas are 2^25 at most
  int down = 4;
  const int least = 61 - 32 - 4 - down - bits;
  int room = up + coarse - least;
  if (kLeastUp < least && room < 0) {
    down -= room;
    room = 0;
  }
  constexpr std::int32_t kFew = 1 << 15;  // bits that count anyway: specks are left out
  const auto either = static_cast<std::uint32_t>((along_x ^ along_x >> 31) | (along_y ^ along_y >> 31) | kFew);
  if (either >> (31 - room) != 0) return false;
  out.right = shift_round(mul_high(along_x * (1 << room), inverse), down);
  out.down = shift_round(mul_high(along_y * (1 << room), inverse), down);
  return true;
}

// The gradient of any triangle, by exact divisions.
struct ExactGradient {
  // `rise` as for small_gradient(), below 2^25.
  ExactGradient(const ScreenXY (&at)[3], std::int32_t rise1, std::int32_t rise2);

  std::int64_t area;              // below 2^34; 0: the triangle covers no pixel, and has no gradient
  std::int64_t along_x, along_y;  // how the value grows a sixteenth of a pixel, times area: below 2^43

  // How it grows a pixel, with this many fraction bits more, to the nearest; `along`: one of the two.
  std::int64_t a_pixel(std::int64_t along, int bits) const {
    return rare_round_div(along * (kSubpixels << bits), area);
  }
};

// What a value of `from` at a point is at the centre of column 0 and line 0, modulo 2^32. Whole pixels and sixteenths
// by themselves, as either fits 32 bits.
inline std::uint32_t at_origin(std::uint32_t from, ScreenXY point, const Gradient& gradient) {
  const std::int32_t x = kSubpixels / 2 - point.x, y = kSubpixels / 2 - point.y;
  const auto pixels = [](std::int32_t v) { return static_cast<std::uint32_t>(v >> 4); };
  static_assert(kSubpixels == 16 && 2 * 15 * std::int64_t{kSteepest} <= INT32_MAX);
  const std::int32_t rest = gradient.right * (x & 15) + gradient.down * (y & 15);
  return from + static_cast<std::uint32_t>(gradient.right) * pixels(x) +
         static_cast<std::uint32_t>(gradient.down) * pixels(y) + static_cast<std::uint32_t>(rest >> 4);
}

}  // namespace spanline
