// A strand with a width: what it covers of a scan line.
#pragma once

#include <cstdint>

#include "core/curve/line_coverage.hpp"
#include "core/curve/strand.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

// How a curve is drawn.
struct Pen {
  std::uint16_t radius = 0;  // 1/16 px; 0: the pixels that the curve runs through
  bool smooth = false;       // 16 samples a pixel; radius > 0

  // Steps of 2^-fineness px at most, in x and in y: a disc of radius r at each point leaves notches of step * step / 4
  // r at most, which smooth ones of half a pixel and more keep to 1/32 px.
  constexpr int fineness() const {
    if (!smooth) return radius != 0 ? 1 : 0;
    return radius < 2 * kSubpixels ? 2 : radius < 8 * kSubpixels ? 1 : 0;
  }
};

// Draws one strand line by line, downwards.
//
// The stroke is what a disc covers that runs along the strand. Where it crosses a row of samples it covers one
// interval: the disc's chord changes continuously while the disc meets the row, and it meets it in one go since the
// strand is y-monotone. So a line takes no more than the smallest and the largest end of the chords. The walk waits at
// the first point that reaches the line; a copy of it runs through those that do.
class Stroke {
 public:
  Stroke() = default;
  Stroke(const Strand& strand, const Pen& pen) : walk_(strand, pen.fineness()), pen_(pen) {}

  // The first line that it may cover a sample of.
  std::int32_t first_line() const { return (walk_.at().y - pen_.radius) >> 4; }

  // Covers what lies on `line`, below all lines before. False where nothing is left for the lines to come.
  bool draw(std::int32_t line, LineCoverage& coverage);

 private:
  bool draw_pixels(std::int32_t line, LineCoverage& coverage);
  bool draw_discs(std::int32_t line, LineCoverage& coverage);

  StrandWalk walk_;
  Pen pen_;
};

}  // namespace spanline
