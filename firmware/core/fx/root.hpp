#pragma once

#include <cstdint>

namespace spanline {

// Integer square roots, cut off: the largest r with r * r <= value.
std::uint32_t square_root(std::uint32_t value);
std::uint32_t square_root(std::uint64_t value);

}  // namespace spanline
