// Wide products and shifts with named rounding.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

namespace spanline {

// Whether the core multiplies 32 bits by 32 to 64. ARMv6-M (M0, M0+) keeps the lower half only, and calls a function of
// some forty instructions for the whole; there such products are put together from halves. Nor does it divide, which
// takes a function of more than a hundred, or count leading zeros.
#if defined(__ARM_ARCH_6M__)
inline constexpr bool kLongMultiply = false, kDivides = false, kCountsZeros = false;
#else
inline constexpr bool kLongMultiply = true, kDivides = true, kCountsZeros = true;
#endif

// mul_high() by products of 16 bits.
constexpr std::int32_t mul_high_by_halves(std::int32_t a, std::int32_t b) {
  const std::int32_t a_high = a >> 16, b_high = b >> 16;
  const std::uint32_t a_low = a & 0xffff, b_low = b & 0xffff;
  const auto a_cross = a_high * static_cast<std::int32_t>(b_low), b_cross = b_high * static_cast<std::int32_t>(a_low);
  const std::int32_t middle = a_cross + static_cast<std::int32_t>(a_low * b_low >> 16);
  return a_high * b_high + (middle >> 16) + ((b_cross + (middle & 0xffff)) >> 16);
}

// High 32 bits of a 64-bit product, cut off (towards minus infinity when signed).
constexpr std::int32_t mul_high(std::int32_t a, std::int32_t b) {
  if constexpr (kLongMultiply) {
    return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b) >> 32);
  } else {
    return mul_high_by_halves(a, b);
  }
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

// value in 0 … 32767.
constexpr std::uint32_t saturate15(std::int32_t value) {
#if defined(__ARM_FEATURE_SAT)
  if (!std::is_constant_evaluated()) return static_cast<std::uint32_t>(__builtin_arm_usat(value, 15));
#endif
  return value < 0 ? 0u : value > 32767 ? 32767u : static_cast<std::uint32_t>(value);
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
