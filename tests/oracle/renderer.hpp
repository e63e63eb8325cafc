// The slow twin of the visible segment generator: one decision for each pixel centre, all of it in exact integers. It
// shares no code with the engine and keeps nothing from one line to the next.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/depth.hpp"
#include "oracle/facet.hpp"
#include "oracle/picture.hpp"

namespace spanline::oracle {

// A facet that covers a pixel centre, with its depth there.
struct Candidate {
  std::uint32_t face;
  Depth depth;
};

class Rendering {
 public:
  Rendering(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // Every facet that covers the pixel; the visible one stands first. Empty: background.
  const std::vector<Candidate>& candidates(int column, int line) const { return pixels_[index(column, line)]; }
  std::uint32_t face(int column, int line) const;
  Picture picture() const;

  void cover(int column, int line, const Candidate& candidate);

 private:
  std::size_t index(int column, int line) const;

  int width_;
  int height_;
  std::vector<std::vector<Candidate>> pixels_;
};

// The exact picture. Pixel (c, Y) has its centre at (16c + 8, 16Y + 8); an edge lives on centres y0 <= y < y1 (y0 < y1)
// and a chord covers centres x_left <= x < x_right, which is the top-left rule. Depth is linear in y along an edge and
// linear in x between the two edges of a chord. Nearer wins, equal depths go to the lower face number. Throws
// std::invalid_argument on a vertex outside the ranges above or a size outside 1 … 2046.
Rendering render(int width, int height, const std::vector<Facet>& facets);

}  // namespace spanline::oracle
