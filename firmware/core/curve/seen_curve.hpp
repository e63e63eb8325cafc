// A curve as it is seen, and how many chords it needs.
//
// In steps of 1 / n a chord leaves its curve by at most |f''| / (8 n n), and f'' is 6 times what lies between the two
// second differences of the control points, which are taken as they lie on the screen. That leaves out perspective:
// along what is nearer at one end t goes faster there, and f'' at the end is as much greater than its second difference
// as the control point next but one is farther off. With none much farther off than another one this holds all along:
// chords of the teapot are off by 1.05 of the tolerance at most, one in 5,000 by more than it.
//
// What a chord is off along the line of sight is not seen, but moves the lines along which surfaces pierce each other:
// second differences of w count, too (DiceView::depth).
#pragma once

#include <cstdint>

#include "core/curve/dice_view.hpp"

namespace spanline {

// What lies a quarter of the way from the first to the last of four, times 2^kQuarterBits.
inline constexpr int kQuarterBits = 6;
template <typename Int>
constexpr Int sum_quarter_way(Int a, Int b, Int c, Int d) {
  return 27 * (a + b) + 9 * c + d;
}

// Where control points are seen.
struct SeenPlaces {
  PackedBox places;
  std::int32_t nearest = INT32_MAX, farthest = INT32_MIN;  // w, Q16.16

  void widen(ScreenXY at, std::int32_t w) {
    places.widen(PackedXY(at));
    if (w < nearest) nearest = w;
    if (w > farthest) farthest = w;
  }
  // Whether SeenCurve is for curves with these control points: all are projected, inside the guard band, and none is
  // more than half as far again as another one. So it is for any of them, then.
  bool allow(const DiceView& view) const;
  // How many bits of w are to be cut off so that sum_quarter_way() has 31.
  int cut() const;
};

class SeenCurve {
 public:
  // The curve of every `stride`th point, of which `at` are the places.
  SeenCurve(const ClipPoint* p, const ScreenXY* at, int stride);
  // The one a quarter of the way from the first to the last of four control curves; `cut`: as SeenPlaces says.
  static SeenCurve quarter_way(const SeenCurve& a, const SeenCurve& b, const SeenCurve& c, const SeenCurve& d, int cut);

  // The square of the number of steps, or more. The same for the curve run backwards.
  std::uint32_t square_of_steps(const DiceView& view) const;

 private:
  SeenCurve() = default;

  struct Second {
    std::int32_t x, y;  // 1/16 px, below 2^17
  } second_[2];
  std::int32_t w_[4];  // Q16.16
};

}  // namespace spanline
