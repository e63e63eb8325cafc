// Which pixels polygons cover, found the slow way in floating point.
#pragma once

#include <cstddef>
#include <vector>

namespace spanline::test {

struct Place {
  double x, y;  // px, y down
};

class Coverage {
 public:
  Coverage(int width, int height) : width_(width), height_(height), covered_(index(0, height)) {}

  // Covers the pixels whose centres lie inside, by the even-odd rule.
  void add(const std::vector<Place>& polygon);

  // Covers one pixel.
  void add(int x, int y);

  bool covered(int x, int y) const { return covered_[index(x, y)]; }

  // Pixels of this picture whose centres are more than a pixel from every polygon of the other.
  int far_from(const Coverage& other) const;

  // Pixels that are open here, and lie more than `inside` px inside of what the other covers, in eighths.
  int holes_against(const Coverage& other, int inside = 8) const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  // Whether any of the pixel's four neighbours, whose centres are a pixel off, is covered, or open if not `wanted`.
  bool any_beside(int x, int y, bool wanted) const;
  bool covers(Place p) const;
  // Whether all places within so many eighths of a pixel of `p` are covered, an eighth of a pixel apart.
  bool covers_about(Place p, int eighths) const;
  double distance_to_outlines(Place p) const;

  int width_, height_;
  int left_ = width_, top_ = height_, right_ = 0, bottom_ = 0;  // what is covered lies in here
  std::vector<bool> covered_;
  std::vector<std::vector<Place>> polygons_;
};

}  // namespace spanline::test
