// Magnitudes, and lengths without a root.
#pragma once

#include <cstdint>

namespace spanline {

constexpr std::uint32_t magnitude(std::int32_t v) { return static_cast<std::uint32_t>(v < 0 ? -v : v); }
constexpr std::uint32_t larger(std::uint32_t a, std::uint32_t b) { return a > b ? a : b; }

// At least the length of (a, b), and at most 1.02 of it and one: the norm of a polygon of 16 corners on the circle. a,
// b < 2^26.
constexpr std::uint32_t length_at_most(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t most = larger(a, b), least = a ^ b ^ most;
  return (larger(64 * most + 13 * least, 54 * most + 37 * least) + 63) >> 6;
}

}  // namespace spanline
