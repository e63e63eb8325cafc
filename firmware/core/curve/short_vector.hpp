// Vectors of which only the direction matters: with a common exponent and so few bits that products of two fit 32.
#pragma once

#include <bit>
#include <cstdint>

namespace spanline {

struct ShortVector {
  static constexpr int kBits = 14;  // of a component: products of two fit 29 bits

  std::int32_t v[3];

  bool is_zero() const { return (v[0] | v[1] | v[2]) == 0; }

  // All bits of the components' magnitudes; those of -2^n are n ones.
  std::uint32_t bits() const {
    const auto of = [](std::int32_t c) { return static_cast<std::uint32_t>(c ^ (c >> 31)); };
    return of(v[0]) | of(v[1]) | of(v[2]);
  }
  ShortVector shifted(int down) const { return {{v[0] >> down, v[1] >> down, v[2] >> down}}; }

  // To kBits bits at most. Shorter ones are exact as they are.
  [[gnu::always_inline]] ShortVector direction() const { return shifted(excess(bits())); }
  // To kBits bits at most by one exponent, and what the two span, which is a direction() then.
  [[gnu::always_inline]] static ShortVector spanned(const ShortVector& a, const ShortVector& b) {
    const int down = excess(a.bits() | b.bits());
    return product(a.shifted(down), b.shifted(down)).direction();
  }

  // What is more than kBits bits.
  static int excess(std::uint32_t bits) {
    const int more = 32 - kBits - std::countl_zero(bits);
    return more & ~(more >> 31);
  }
  // Of vectors of kBits bits.
  static ShortVector product(const ShortVector& a, const ShortVector& b) {
    return {{a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2], a.v[0] * b.v[1] - a.v[1] * b.v[0]}};
  }
};

}  // namespace spanline
