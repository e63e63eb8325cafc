#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/fx/bits.hpp"

namespace spanline {

namespace detail {
// Seeds of the reciprocal: entry i is 2^15 / m for the middle m of the i-th of 256 equal parts of [1/2, 1).
inline constexpr auto kReciprocalSeeds = [] {
  std::array<std::uint16_t, 256> seeds{};
  for (std::uint32_t i = 0; i < 256; ++i) seeds[i] = static_cast<std::uint16_t>((1u << 25) / (513 + 2 * i));
  return seeds;
}();
static_assert(kReciprocalSeeds[0] == 65408 && kReciprocalSeeds[255] == 32800);
}  // namespace detail

// 2^61 / w for w in [2^30, 2^31), at most 2^31 - 1, with a relative error below 2^-27. Two Newton steps from a 512-byte
// table and no divide: one rule for every core, so that a projected vertex is the same everywhere.
constexpr std::uint32_t reciprocal_normalised(std::uint32_t w) {
  std::uint32_t r = static_cast<std::uint32_t>(detail::kReciprocalSeeds[(w >> 22) & 255]) << 15;
  for (int step = 0; step < 2; ++step) {
    const std::int32_t error = static_cast<std::int32_t>((1u << 29) - mul_high(w, r));  // Q3.29: 1 - w * r
    const std::int64_t correction = static_cast<std::int64_t>(r) * error;               // |error| < 2^21
    r += static_cast<std::uint32_t>(correction >> 29);
  }
  return r < 0x7fffffffu ? r : 0x7fffffffu;
}

}  // namespace spanline
