#pragma once

#include <cstdint>

namespace spanline {

// A run of scan lines, [top, bottom).
struct Band {
  std::uint16_t top = 0, bottom = 0;
  constexpr bool empty() const { return top >= bottom; }
  constexpr std::uint16_t lines() const {
    return empty() ? std::uint16_t{0} : static_cast<std::uint16_t>(bottom - top);
  }
  friend constexpr bool operator==(const Band&, const Band&) = default;
};

}  // namespace spanline
