// The pixel formats that core renders and panels take. Here because core and HAL both name them and never meet.
#pragma once

#include <cstdint>

namespace spanline {

enum class PixelFormat : std::uint8_t {
  rgb565,  // two bytes a pixel, high byte first (wire order of ILI9341, ST7789 …)
  grey8,   // one byte a pixel
  grey4,   // two pixels a byte, left one in the high nibble, ordered dither
  mono1,   // eight pixels a byte, left one in bit 7, ordered dither
};

constexpr std::uint32_t bits_per_pixel(PixelFormat format) {
  constexpr std::uint8_t kBits[] = {16, 8, 4, 1};
  return kBits[static_cast<std::uint8_t>(format)];
}

constexpr std::uint32_t bytes_per_line(PixelFormat format, std::uint32_t width) {
  switch (format) {
    case PixelFormat::rgb565:
      return width * 2;
    case PixelFormat::grey8:
      return width;
    case PixelFormat::grey4:
      return (width + 1) / 2;
    default:
      return (width + 7) / 8;
  }
}

}  // namespace spanline
