// Single pixels: colours as the panel wants them, and the thresholds of ordered dither.
#pragma once

#include <cstdint>

#include "core/base/pixel_format.hpp"
#include "core/scene/format.hpp"

namespace spanline {

// RGB565 with the bytes in wire order: read as a little-endian half-word, the panel's high byte comes first.
constexpr std::uint16_t rgb565_wire(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  const std::uint32_t v = (r & 0xf8u) << 8 | (g & 0xfcu) << 3 | b >> 3;
  return static_cast<std::uint16_t>(v >> 8 | v << 8);
}

// The same of a colour in light `sum`, Q8.8 and at most 256, with each channel rounded to 8 bits.
constexpr std::uint16_t lit_rgb565_wire(const Rgb8& color, std::uint32_t sum) {
  static_assert(255 * 256 + 128 < 1 << 16, "so red and blue share a word");
  const std::uint32_t rb = (color.r | std::uint32_t{color.b} << 16) * sum + 0x00800080u, g = color.g * sum + 128;
  return __builtin_bswap16(static_cast<std::uint16_t>((rb & 0xf800u) | (g >> 5 & 0x07e0u) | rb >> 27));
}

// Luma of ITU-R BT.601 in 8 bits; white stays 255.
constexpr std::uint8_t luminance(const Rgb8& c) {
  return static_cast<std::uint8_t>((77u * c.r + 150u * c.g + 29u * c.b + 128u) >> 8);
}

// A flat colour as the painter fills it: an RGB565 pixel in wire order, or the luminance.
constexpr std::uint16_t flat_payload(PixelFormat format, const Rgb8& c) {
  return format == PixelFormat::rgb565 ? rgb565_wire(c.r, c.g, c.b) : luminance(c);
}

// The colour of a payload, for what lies under others: bits of RGB565 replicated, a luminance as a grey.
constexpr Rgb8 payload_color(PixelFormat format, std::uint16_t payload) {
  if (format != PixelFormat::rgb565) {
    const auto grey = static_cast<std::uint8_t>(payload);
    return {grey, grey, grey};
  }
  const std::uint32_t v = (payload & 255u) << 8 | payload >> 8;
  const std::uint32_t r = v >> 11, g = v >> 5 & 63u, b = v & 31u;
  return {static_cast<std::uint8_t>(r << 3 | r >> 2), static_cast<std::uint8_t>(g << 2 | g >> 4),
          static_cast<std::uint8_t>(b << 3 | b >> 2)};
}

// `color` in front of `behind`, of which the part `transmission` / 255 shines through, a channel; to the nearest.
constexpr Rgb8 seen_through(const Rgb8& color, const Rgb8& transmission, const Rgb8& behind) {
  constexpr auto mix = [](std::uint32_t own, std::uint32_t t, std::uint32_t back) {
    return static_cast<std::uint8_t>(((own * (255 - t) + back * t + 127) * 0x8081u) >> 23);  // / 255
  };
  return {mix(color.r, transmission.r, behind.r), mix(color.g, transmission.g, behind.g),
          mix(color.b, transmission.b, behind.b)};
}

// Bayer's 8 x 8 matrix (1973), 0 … 63: the bits of x ^ y and y, reversed and interleaved.
constexpr std::uint32_t bayer8(std::uint32_t x, std::uint32_t y) {
  const std::uint32_t d = x ^ y;
  return (d & 1u) << 5 | (y & 1u) << 4 | (d & 2u) << 2 | (y & 2u) << 1 | (d & 4u) >> 1 | (y & 4u) >> 2;
}

// A luminance as one of 16 levels: 17 * level on the average. 0 and 255 are met exactly.
constexpr std::uint32_t dither_grey4(std::uint32_t grey, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t threshold = bayer8(x, y) * 4 + 1;  // 1 … 253 of 255
  return ((grey * 15 + threshold) * 0x8081u) >> 23;      // / 255
}

// A luminance as on or off.
constexpr std::uint32_t dither_mono(std::uint32_t grey, std::uint32_t x, std::uint32_t y) {
  return grey > bayer8(x, y) * 4 + 1 ? 1u : 0u;
}

}  // namespace spanline
