#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/fx/bits.hpp"

namespace spanline {

namespace detail {
// The seed of the reciprocal of w in [2^30, 2^31): 2^9 / m for the middle m of the one of 256 equal parts of [1/2, 1)
// that w / 2^31 lies in,
constexpr std::uint32_t divided_seed(std::uint32_t w) {
  const std::uint32_t twice = w >> 21 | 1u;
  return ((1u << 19) + twice / 2) / twice;
}
// or from a table of 512 bytes.
inline constexpr auto kReciprocalSeeds = [] {
  std::array<std::uint16_t, 256> seeds{};
  for (std::uint32_t i = 0; i < 256; ++i) seeds[i] = static_cast<std::uint16_t>(divided_seed((256 + i) << 22));
  return seeds;
}();
static_assert(kReciprocalSeeds[0] == 1022 && kReciprocalSeeds[255] == 513);
}  // namespace detail

// 2^61 / w for w in [2^30, 2^31), at most 2^31 - 1, with a relative error below 2^-25. A step of third order from a
// seed: no product of more than 32 bits, and no divide where the core has none. One rule for every core, so that a
// projected vertex is the same everywhere.
//
// With the seed s and e = 1 - s * w, 1 / w = s * (1 + e + e^2) * (1 + O(e^3)), and |e| < 2^-8.7.
// kTable: from the table wherever it is, which is three instructions less; else not where the core divides.
template <bool kTable = !kDivides>
constexpr std::uint32_t reciprocal_normalised(std::uint32_t w) {
  const std::uint32_t seed = kTable ? detail::kReciprocalSeeds[(w >> 22) & 255] : detail::divided_seed(w);
  const auto error = static_cast<std::int32_t>(0u - (w >> 1) * seed);  // 1 is 2^39, which 32 bits leave out
  const std::int32_t half = error >> 15;
  const std::int32_t step = (error + (half * half >> 9)) >> 10;
  return (seed << 21) + static_cast<std::uint32_t>(static_cast<std::int32_t>(seed) * step >> 8);
}

// How many bits numbers in [1, 2^31) are to go up to be divisors. Of numbers alike most need what the last one did, and
// that is cheaper to find out than how many it is.
class Normaliser {
 public:
  int up(std::uint32_t w) {
    if constexpr (kCountsZeros) {
      if (w == 0) __builtin_unreachable();
      return std::countl_zero(w) - 1;
    } else {
      if (w >> (30 - up_) != 1) up_ = std::countl_zero(w) - 1;
      return up_;
    }
  }

 private:
  int up_ = 0;
};

}  // namespace spanline
