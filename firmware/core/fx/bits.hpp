// Wide products and shifts with named rounding.
#pragma once

#include <bit>
#include <cstdint>

namespace spanline {

// High 32 bits of a 64-bit product, cut off (towards minus infinity when signed).
constexpr std::int32_t mul_high(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b) >> 32);
}
constexpr std::uint32_t mul_high(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
}

// value / 2^shift to the nearest, halves upwards.
template <typename T>
constexpr T shift_round(T value, int shift) {
  return (value + (T{1} << (shift - 1))) >> shift;
}

constexpr std::int32_t saturate32(std::int64_t value) {
  if (value > INT32_MAX) return INT32_MAX;
  if (value < -INT32_MAX) return -INT32_MAX;
  return static_cast<std::int32_t>(value);
}

// Quotient towards minus infinity; divisor > 0.
template <typename T>
constexpr T floor_div(T dividend, T divisor) {
  const T quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

// Quotient to the nearest, halves upwards; divisor > 0 and |dividend| + divisor / 2 within T.
template <typename T>
constexpr T round_div(T dividend, T divisor) {
  return floor_div<T>(dividend + divisor / 2, divisor);
}

}  // namespace spanline
