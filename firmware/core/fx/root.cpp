#include "core/fx/root.hpp"

#include <bit>

namespace spanline {

namespace {

// Digit by digit, two bits of the radicand a step: no multiply and no divide, the same on every core.
template <typename T>
std::uint32_t root(T value) {
  if (value == 0) return 0;
  T rest = value;
  T result = 0;
  T bit = T{1} << ((static_cast<int>(std::bit_width(value)) - 1) & ~1);
  while (bit != 0) {
    if (rest >= result + bit) {
      rest -= result + bit;
      result = (result >> 1) + bit;
    } else {
      result >>= 1;
    }
    bit >>= 2;
  }
  return static_cast<std::uint32_t>(result);
}

}  // namespace

std::uint32_t square_root(std::uint32_t value) { return root(value); }
std::uint32_t square_root(std::uint64_t value) { return root(value); }

}  // namespace spanline
