#include "core/fx/sine.hpp"

#include "core/fx/bits.hpp"

namespace spanline {

namespace {

// sin of t eighths of a turn, t in [0, 1] as Q1.30: odd Taylor polynomial in x = t * pi / 4, Q2.30 throughout; the
// first term left out, x^11 / 11!, is below 2^-29.
std::int32_t sine_octant(std::int32_t t) {
  constexpr std::int32_t kQuarterPi = 843314857;  // Q2.30
  const std::int32_t x = mul_high(t, kQuarterPi) << 2;
  const std::int32_t xx = mul_high(x, x) << 2;
  std::int32_t sum = 2959;                      // 1 / 9!
  sum = -213044 + (mul_high(sum, xx) << 2);     // 1 / 7!
  sum = 8947849 + (mul_high(sum, xx) << 2);     // 1 / 5!
  sum = -178956971 + (mul_high(sum, xx) << 2);  // 1 / 3!
  return x + (mul_high(x, mul_high(sum, xx) << 2) << 2);
}

// cos likewise, to x^10 / 10!.
std::int32_t cosine_octant(std::int32_t t) {
  constexpr std::int32_t kQuarterPi = 843314857;
  const std::int32_t x = mul_high(t, kQuarterPi) << 2;
  const std::int32_t xx = mul_high(x, x) << 2;
  std::int32_t sum = -296;                      // 1 / 10!
  sum = 26631 + (mul_high(sum, xx) << 2);       // 1 / 8!
  sum = -1491308 + (mul_high(sum, xx) << 2);    // 1 / 6!
  sum = 44739243 + (mul_high(sum, xx) << 2);    // 1 / 4!
  sum = -536870912 + (mul_high(sum, xx) << 2);  // 1 / 2!
  return Fx30::kOne + (mul_high(sum, xx) << 2);
}

}  // namespace

Fx30 sine(Turn16 angle) {
  const std::uint32_t octant = angle.raw >> 13;
  const std::int32_t within = angle.raw & 0x1fff;
  const std::int32_t t = (octant & 1u) != 0 ? 0x2000 - within : within;  // distance from the nearer axis
  const std::int32_t q30 = t << 17;
  const bool near_zero = ((octant + 1) & 2u) == 0;  // octants 0, 3, 4, 7 lie beside a zero of the sine
  const std::int32_t magnitude = near_zero ? sine_octant(q30) : cosine_octant(q30);
  return {octant < 4 ? magnitude : -magnitude};
}

Fx30 cosine(Turn16 angle) { return sine(angle + Turn16{0x4000}); }

}  // namespace spanline
