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

// Whether the core takes two products of 16 bits at once (Armv7E-M: M4, M7).
#if defined(__ARM_FEATURE_SIMD32)
inline constexpr bool kDualMultiply = true;
#else
inline constexpr bool kDualMultiply = false;
#endif

// Two numbers of 16 bits in a word.
constexpr std::uint32_t pack_halves(std::int32_t low, std::int32_t high) {
  return (static_cast<std::uint32_t>(low) & 0xffffu) | static_cast<std::uint32_t>(high) << 16;
}
constexpr std::int32_t low_half(std::uint32_t pair) { return static_cast<std::int16_t>(pair); }
constexpr std::int32_t high_half(std::uint32_t pair) { return static_cast<std::int32_t>(pair) >> 16; }

// pack_halves(low >> 15, high >> 15).
inline std::uint32_t pack_halves_of_q15(std::int32_t low, std::int32_t high) {
#if defined(__ARM_FEATURE_SIMD32)
  std::uint32_t out;
  asm("pkhtb %0, %1, %2, asr #15" : "=r"(out) : "r"(high << 1), "r"(low));
  return out;
#else
  return pack_halves(low >> 15, high >> 15);
#endif
}

// Differences of the halves, each modulo 2^16.
constexpr std::uint32_t subtract_halves(std::uint32_t a, std::uint32_t b) {
#if defined(__ARM_FEATURE_SIMD32)
  if (!std::is_constant_evaluated()) {
    return static_cast<std::uint32_t>(__builtin_arm_ssub16(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)));
  }
#endif
  return ((a - b) & 0xffffu) | ((a & 0xffff0000u) - (b & 0xffff0000u));
}

// The lesser and the greater of the halves.
inline std::uint32_t least_halves(std::uint32_t a, std::uint32_t b) {
#if defined(__ARM_FEATURE_SIMD32)
  std::uint32_t out;
  asm("ssub16 %0, %1, %2\n\tsel %0, %2, %1" : "=&r"(out) : "r"(a), "r"(b) : "cc");
  return out;
#else
  return pack_halves(low_half(a) < low_half(b) ? low_half(a) : low_half(b),
                     high_half(a) < high_half(b) ? high_half(a) : high_half(b));
#endif
}
inline std::uint32_t greatest_halves(std::uint32_t a, std::uint32_t b) {
#if defined(__ARM_FEATURE_SIMD32)
  std::uint32_t out;
  asm("ssub16 %0, %1, %2\n\tsel %0, %1, %2" : "=&r"(out) : "r"(a), "r"(b) : "cc");
  return out;
#else
  return pack_halves(low_half(a) > low_half(b) ? low_half(a) : low_half(b),
                     high_half(a) > high_half(b) ? high_half(a) : high_half(b));
#endif
}

// The determinant of two pairs: a's lower half times b's higher one less the other way round. Below 2^31 where each
// half is not -2^15.
constexpr std::int32_t cross_halves(std::uint32_t a, std::uint32_t b) {
#if defined(__ARM_FEATURE_SIMD32)
  if (!std::is_constant_evaluated()) {
    return __builtin_arm_smusdx(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
  }
#endif
  return low_half(a) * high_half(b) - high_half(a) * low_half(b);
}

// sum + the products of the lower and of the higher halves, modulo 2^32.
inline std::uint32_t add_products(std::uint32_t a, std::uint32_t b, std::uint32_t sum) {
#if defined(__ARM_FEATURE_SIMD32)
  const auto word = [](std::uint32_t v) { return static_cast<std::int32_t>(v); };
  return static_cast<std::uint32_t>(__builtin_arm_smlad(word(a), word(b), word(sum)));
#else
  return sum + static_cast<std::uint32_t>(low_half(a) * low_half(b)) +
         static_cast<std::uint32_t>(high_half(a) * high_half(b));
#endif
}

// High 32 bits of a 64-bit product, cut off (towards minus infinity when signed).
constexpr std::int32_t mul_high(std::int32_t a, std::int32_t b) {
  if constexpr (kLongMultiply) {
    return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b) >> 32);
  } else {
    return mul_high_by_halves(a, b);
  }
}

// The same to the nearest, halves upwards.
inline std::int32_t mul_high_round(std::int32_t a, std::int32_t b) {
#if defined(__ARM_FEATURE_SIMD32)
  std::int32_t out;
  asm("smmulr %0, %1, %2" : "=r"(out) : "r"(a), "r"(b));
  return out;
#else
  if constexpr (kLongMultiply) {
    return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b + (std::int64_t{1} << 31)) >> 32);
  } else {
    const std::uint32_t low = static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
    return mul_high_by_halves(a, b) + static_cast<std::int32_t>(low >> 31);
  }
#endif
}

// sum + mul_high(a, b).
inline std::int32_t add_high(std::int32_t a, std::int32_t b, std::int32_t sum) {
#if defined(__ARM_FEATURE_SIMD32)
  std::int32_t out;
  asm("smmla %0, %1, %2, %3" : "=r"(out) : "r"(a), "r"(b), "r"(sum));
  return out;
#else
  return sum + mul_high(a, b);
#endif
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

// value in 0 … 2^kBits - 1.
template <int kBits>
constexpr std::uint32_t saturate(std::int32_t value) {
#if defined(__ARM_FEATURE_SAT)
  if (!std::is_constant_evaluated()) return static_cast<std::uint32_t>(__builtin_arm_usat(value, kBits));
#endif
  constexpr std::int32_t kMost = (1 << kBits) - 1;
  return static_cast<std::uint32_t>(value < 0 ? 0 : value > kMost ? kMost : value);
}
constexpr std::uint32_t saturate15(std::int32_t value) { return saturate<15>(value); }

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
