#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace spanline {

namespace detail {
// Entry i is 2^15 / sqrt(m) for the middle m of the i-th of the 192 parts, 1/256 wide, of [1/4, 1).
inline constexpr auto kInverseRootSeeds = [] {
  std::array<std::uint16_t, 192> seeds{};
  std::uint32_t root = 0xffff;
  for (std::uint32_t i = 0; i < 192; ++i) {
    while (std::uint64_t{root} * root * (2 * i + 129) > std::uint64_t{512} << 30) --root;
    seeds[i] = static_cast<std::uint16_t>(root);
  }
  return seeds;
}();
}  // namespace detail

// 1 / sqrt(value) as factor / 2^(31 - up), factor in [2^15 - 1, 2^16], with a relative error below 2^-14; value > 0. A
// Newton step from a table of 384 bytes and no divide: the same on every core.
struct InverseRoot {
  std::uint32_t factor = 0;
  int up;

  explicit constexpr InverseRoot(std::uint32_t value) : up(std::countl_zero(value) / 2) {
    if (value == 0) __builtin_unreachable();  // else the shift would be by 32
    const std::uint32_t m = value << (2 * up);
    const std::uint32_t r = detail::kInverseRootSeeds[(m >> 24) - 64];
    const std::uint32_t rest = (3u << 30) - (m >> 16) * (r * r >> 16);  // Q2.30: 3 - m r r
    factor = r * (rest >> 16) >> 15;
  }
};

}  // namespace spanline
