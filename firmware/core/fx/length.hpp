// Lengths without a root.
#pragma once

#include <cstdint>

namespace spanline {

// At least the length of (a, b), and at most 1.02 of it and one: the norm of a polygon of 16 corners on the circle. a,
// b < 2^26.
constexpr std::uint32_t length_at_most(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t most = a > b ? a : b, least = a ^ b ^ most;
  const std::uint32_t steep = 64 * most + 13 * least, flat = 54 * most + 37 * least;
  return ((steep > flat ? steep : flat) + 63) >> 6;
}

}  // namespace spanline
