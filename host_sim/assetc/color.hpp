#pragma once

#include <cstdint>

#include "core/scene/format.hpp"

namespace spanline::host {

using Color = Rgb8;

// 0 … 1 to 0 … 255, rounded to nearest; what lies outside is cut off.
constexpr std::uint8_t channel(double value) {
  const double scaled = value * 255 + 0.5;
  return static_cast<std::uint8_t>(scaled < 0 ? 0 : scaled > 255 ? 255 : scaled);
}

}  // namespace spanline::host
