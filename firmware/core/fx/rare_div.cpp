#include "core/fx/rare_div.hpp"

namespace spanline {

namespace {

std::uint64_t by_bits(std::uint64_t rest, std::uint64_t part) {
  std::uint64_t bit = 1, quotient = 0;
  while (part <= rest >> 1) {
    part <<= 1;
    bit <<= 1;
  }
  for (; bit != 0; bit >>= 1, part >>= 1) {
    if (rest < part) continue;
    rest -= part;
    quotient |= bit;
  }
  return quotient;
}

// By a divisor of 16 bits: a remainder and 16 bits more are a word.
std::uint64_t by_digits(std::uint64_t dividend, std::uint32_t divisor) {
  std::uint64_t quotient = 0;
  std::uint32_t rest = 0;
  int digits = 4;
  if (dividend >> 32 == 0) {
    dividend <<= 32;
    digits = 2;
  }
  do {
    rest = rest << 16 | static_cast<std::uint32_t>(dividend >> 48);
    dividend <<= 16;
    quotient = quotient << 16 | rest / divisor;
    rest %= divisor;
  } while (--digits != 0);
  return quotient;
}

}  // namespace

// Of a negative dividend: its quotient rounded down is the complement of its complement's, cut off.
std::int64_t rare_floor_div(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t sign = dividend >> 63;
  const auto magnitude = static_cast<std::uint64_t>(dividend ^ sign);
  const auto by = static_cast<std::uint64_t>(divisor);
  const std::uint64_t quotient =
      by >> 16 == 0 ? by_digits(magnitude, static_cast<std::uint32_t>(by)) : by_bits(magnitude, by);
  return static_cast<std::int64_t>(quotient) ^ sign;
}

std::int64_t rare_round_div(std::int64_t dividend, std::int64_t divisor) {
  return rare_floor_div(dividend + (divisor >> 1), divisor);
}

}  // namespace spanline
