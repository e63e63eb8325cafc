#pragma once

#include "core/base/slice.hpp"
#include "core/curve/line_coverage.hpp"
#include "core/geom/screen.hpp"
#include "core/shade/brightness.hpp"
#include "core/shade/pixel.hpp"
#include "core/vsg/layer.hpp"
#include "core/vsg/visible_span.hpp"

namespace spanline {

// Writes the visible spans of a line as pixels in wire order. Spans come left to right and without gaps, so nothing is
// cleared.
class Painter {
 public:
  Painter() = default;
  constexpr explicit Painter(const Screen& screen)
      : screen_(screen), line_bytes_(bytes_per_line(screen.format, screen.width)) {}

  const Screen& screen() const { return screen_; }
  // Bytes that begin_line() needs.
  std::uint32_t line_bytes() const { return line_bytes_; }

  // What lies behind the lines to come; to be kept until the last of them.
  void begin_lines(const BackgroundRecord& background);
  // The spans to come belong to `line`; `out` begins on a word boundary and holds line_bytes() at least.
  void begin_line(std::uint16_t line, std::uint8_t* out) {
    begin_plain_line(line, out);
    if (gradient_ != nullptr) [[unlikely]]
      shade_background();
  }
  // The same of RGB565 before one colour.
  void begin_plain_lines(const Rgb8& background) {
    background_ = rgb565_wire(background.r, background.g, background.b);
  }
  void begin_plain_line(std::uint16_t line, std::uint8_t* out) {
    line_ = line;
    out_ = out;
  }
  void span(const VisibleSpan& span);
  // A span of one colour, as flat_payload() gives it.
  void fill(std::uint32_t left, std::uint32_t right, std::uint16_t payload);
  // A span of a triangle's brightness in a material's colours (SmoothCache::colors).
  void smooth(std::uint32_t left, std::uint32_t right, const BrightnessPlane& plane, const std::uint16_t* colors);
  std::uint8_t* out() const { return out_; }                // the line
  std::uint16_t background() const { return background_; }  // of the line
  // Layers are put over one another in 8 bits a channel, the farthest first.
  void layers(const LayeredSpan& span);

  // Paints what `coverage` holds of this line over its pixels, and takes it out of there: with c of 16 samples covered
  // a pixel becomes (color * c + pixel * (16 - c)) / 16. Where pixels are dithered, this is dithered again.
  void cover(const Rgb8& color, LineCoverage& coverage);

 private:
  void shade_background();
  void set_background(const Rgb8& color);
  void flat_layers(const LayeredSpan& span);
  void pixel(std::uint32_t x, const Rgb8& color);
  void gouraud(const VisibleSpan& span);
  void gouraud_rgb565(const VisibleSpan& span, const std::int32_t (&from)[3], const std::int32_t (&to)[3]);
  void gouraud_grey(const VisibleSpan& span, const std::int32_t (&from)[3], const std::int32_t (&to)[3]);
  void put_grey(std::uint32_t x, std::uint32_t grey);
  void cover_grey(std::uint32_t x, std::uint32_t grey, std::uint32_t part);

  Screen screen_;
  std::uint32_t line_bytes_ = 0;
  const BackgroundRecord* gradient_ = nullptr;  // the background, where it changes from line to line
  std::uint8_t* out_ = nullptr;
  std::uint16_t line_ = 0;
  std::uint16_t background_ = 0;  // payload
  Rgb8 background_color_{};
};

}  // namespace spanline
