// Screen space: 28.4 coordinates, scan lines, pixel columns.
#pragma once

#include <bit>
#include <cstdint>

#include "core/base/pixel_format.hpp"
#include "core/fx/bits.hpp"

namespace spanline {

struct Screen {
  std::uint16_t width = 0;   // px
  std::uint16_t height = 0;  // px
  PixelFormat format = PixelFormat::rgb565;
};

inline constexpr std::uint16_t kMaxExtent = 2046;  // px, width or height: with the guard band it fills 28.4 in 16 bits
inline constexpr std::int32_t kSubpixels = 16;     // a pixel is 16 units of 28.4; its centre lies at +8

// A point on the screen, 28.4 px, y down. On a word boundary, so that it is read and copied as one word.
struct alignas(4) ScreenXY {
  std::int16_t x = 0, y = 0;
  friend constexpr bool operator==(const ScreenXY&, const ScreenXY&) = default;
};

// A point as one word, which is how it is read at once.
struct PackedXY {
  std::uint32_t word;

  constexpr explicit PackedXY(ScreenXY p) : word(std::bit_cast<std::uint32_t>(p)) {}
  constexpr explicit PackedXY(std::uint32_t w) : word(w) {}
  constexpr ScreenXY unpacked() const { return std::bit_cast<ScreenXY>(word); }
  constexpr std::int32_t x() const { return static_cast<std::int16_t>(word); }
  constexpr std::int32_t y() const { return static_cast<std::int32_t>(word) >> 16; }
};
static_assert(PackedXY(ScreenXY{-1, 2}).x() == -1 && PackedXY(ScreenXY{-1, 2}).y() == 2, "little-endian");

// What points lie between, both ways at once.
struct PackedBox {
  PackedXY low{ScreenXY{INT16_MAX, INT16_MAX}}, high{ScreenXY{INT16_MIN, INT16_MIN}};

  void widen(PackedXY p) {
    low.word = least_halves(low.word, p.word);
    high.word = greatest_halves(high.word, p.word);
  }
};

// A run of pixel columns of one line, [left, right).
struct Columns {
  std::uint16_t left = 0, right = 0;
  constexpr bool empty() const { return left >= right; }
  friend constexpr bool operator==(const Columns&, const Columns&) = default;
};

// The first scan line (or pixel column) whose centre is at or after a 28.4 coordinate: ceil((v - 8) / 16). An edge
// lives on the lines first_centre(y0) … first_centre(y1) - 1: the half-open rule, and with the same in x the top-left
// rule.
constexpr std::int32_t first_centre(std::int32_t v) { return (v + 7) >> 4; }

// Doubled signed area of a triangle; y points down, so it is negative where the triangle runs counter-clockwise to the
// eye. Points of the guard band: it is below 2^31, whatever its terms are.
constexpr std::int32_t doubled_area(PackedXY a, PackedXY b, PackedXY c) {
  const auto product = [](std::int32_t p, std::int32_t q) {
    return static_cast<std::uint32_t>(p) * static_cast<std::uint32_t>(q);
  };
  const std::int32_t x = a.x(), y = a.y();
  return static_cast<std::int32_t>(product(b.x() - x, c.y() - y) - product(c.x() - x, b.y() - y));
}
constexpr std::int32_t doubled_area(ScreenXY a, ScreenXY b, ScreenXY c) {
  return doubled_area(PackedXY(a), PackedXY(b), PackedXY(c));
}

// The same of points that differ by less than 2^15 units each way.
constexpr std::int32_t doubled_area_near(PackedXY a, PackedXY b, PackedXY c) {
  if constexpr (!kDualMultiply) return doubled_area(a, b, c);
  return cross_halves(subtract_halves(b.word, a.word), subtract_halves(c.word, a.word));
}

// Whether a triangle runs counter-clockwise to the eye.
constexpr bool is_front(ScreenXY a, ScreenXY b, ScreenXY c) { return doubled_area(a, b, c) < 0; }

}  // namespace spanline
