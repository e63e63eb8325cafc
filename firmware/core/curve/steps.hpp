// How many chords a curve needs to stay within a tolerance on the screen.
//
// One that is inside the guard band is looked at as it is seen (seen_curve.hpp). For the others there is a bound: in
// steps of 1 / n a chord leaves its curve by at most max |f''| / (8 n n), and f'' is 6 times a second difference d of
// the control points. On the screen that is d.xy - p * d.w over w, p the place there: what is farther ahead bends less,
// and what of a second difference runs along the line of sight is not seen.
#pragma once

#include <cstdint>

#include "core/curve/dice_view.hpp"
#include "core/curve/reach.hpp"

namespace spanline {

// What the places of control points lie between, as far as they are seen: Q1.31 guard bands off the screen's centre.
struct PlaceBounds {
  struct Range {
    std::int32_t middle;  // its negative
    std::int32_t half;    // of what it spans
  } x, y;

  PlaceBounds(const PackedBox& places, const DiceView& view);
};

// The square of the number of steps, or more, from 1 to the square of kMaxSteps, that the curve of every `stride`th
// point can do with, whose places `bounds` hold; found without the last `down` bits, so many that 27 are left.
std::uint32_t square_of_steps_at_most(const ClipPoint* p, int stride, const PlaceBounds& bounds, int down,
                                      const DiceView& view);

// The square of the number of steps, or more, of that curve by itself; `at` are the places of the points. The same for
// the curve run backwards.
std::uint32_t square_of_steps(const ClipPoint* p, const ScreenXY* at, int stride, const DiceView& view);

// The least number of steps whose square is `square` or more; 1 … kMaxSteps.
std::uint32_t steps_of(std::uint32_t square);

// How many equal steps in t bring the curve's chords on the screen within the tolerance: 1 … kMaxSteps. The same for
// the curve run backwards.
std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view);

}  // namespace spanline
