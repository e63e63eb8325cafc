#pragma once

#include <compare>
#include <cstdint>

namespace spanline {

// A signed fixed-point number with F fraction bits in 32 bits: value = raw / 2^F. Integer bits count the sign (Q16.16 =
// Fx16).
template <int F>
struct Fixed {
  static constexpr int kFraction = F;
  static constexpr std::int32_t kOne = F < 31 ? std::int32_t{1} << (F & 31) : INT32_MAX;
  std::int32_t raw = 0;

  static constexpr Fixed from_raw(std::int32_t raw) { return Fixed{raw}; }
  static constexpr Fixed from_int(std::int32_t whole) { return Fixed{whole * kOne}; }

  friend constexpr Fixed operator+(Fixed a, Fixed b) { return {a.raw + b.raw}; }
  friend constexpr Fixed operator-(Fixed a, Fixed b) { return {a.raw - b.raw}; }
  constexpr Fixed operator-() const { return {-raw}; }
  friend constexpr bool operator==(Fixed a, Fixed b) = default;
  friend constexpr auto operator<=>(Fixed a, Fixed b) = default;
};

using Fx12 = Fixed<12>;  // Q20.12: focal lengths in px
using Fx16 = Fixed<16>;  // Q16.16: world coordinates and lengths, -32768 … 32767.99998
using Fx30 = Fixed<30>;  // Q2.30: rotations and unit vectors, -2 … 1.999999999

// An angle as a fraction of a turn: 65536 a turn, wrapping by itself.
struct Turn16 {
  std::uint16_t raw = 0;
  friend constexpr Turn16 operator+(Turn16 a, Turn16 b) { return {static_cast<std::uint16_t>(a.raw + b.raw)}; }
};

}  // namespace spanline
