// Exact depths for the oracle.
#pragma once

#include <cstdint>

#include "oracle/facet.hpp"

namespace spanline::oracle {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): an alias takes no __extension__

// A depth as a fraction in 1/256 of a --screen unit (Q16.8 made exact). With |z| <= kMaxDepth, |x|, |y| <= 2^15 in 1/16
// px the denominator (a chord's width times its two edges' heights) stays under 2^49 and the numerator under 2^75, so
// that a difference of two depths times both denominators stays under 2^125 and fits Wide.
struct Depth {
  Wide numerator = 0;
  std::int64_t denominator = 1;  // > 0
};

// Sign of a - b.
constexpr int compare_depths(const Depth& a, const Depth& b) {
  const Wide left = a.numerator * b.denominator;
  const Wide right = b.numerator * a.denominator;
  return left < right ? -1 : left > right ? 1 : 0;
}

// |a - b| < tolerance, exactly. `tolerance` in 1/256 unit, 0 … 65536.
constexpr bool closer_than(const Depth& a, const Depth& b, std::int64_t tolerance) {
  const Wide difference = a.numerator * b.denominator - b.numerator * a.denominator;
  const Wide limit = static_cast<Wide>(a.denominator) * b.denominator * tolerance;
  return -limit < difference && difference < limit;
}

// In --screen units, rounded: for messages only, never for a decision.
constexpr double in_units(const Depth& depth) {
  return static_cast<double>(depth.numerator) / (256.0 * static_cast<double>(depth.denominator));
}

}  // namespace spanline::oracle
