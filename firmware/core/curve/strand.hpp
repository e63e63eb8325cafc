// Strands: the y-monotone pieces of a curve, each walked from its upper end down, so that the walk can pause at the end
// of a scan line and go on in the next one, whatever lies between.
#pragma once

#include <cstdint>

#include "core/curve/adaptive_steps.hpp"

namespace spanline {

// A curve with control points within kMaxCurve is walked in 64-bit registers: they are exact down to steps so fine that
// none is longer than a pixel, and no curve need be cut.
inline constexpr int kStrandLevels = 15;
using StrandSteps = AdaptiveSteps<std::int64_t, 18, kStrandLevels, 4>;
static_assert(kMaxCurve <= 1 << (18 - 1));
// The longest step at the finest level is 3 * the longest leg / 2^level, in 1/16 px.
static_assert((3 * 2 * kMaxCurve) >> kStrandLevels <= 16);

// A y-monotone piece of `curve`: t from `from` to `to` in units of 2^-kStrandLevels, y not decreasing.
struct Strand {
  Cubic curve;
  std::uint16_t from, to;
};

// The strands of a curve, at most three. They share their ends, exact points of the curve; the turning points in
// between are exact to 2^-kStrandLevels in t, so that on a strand y may decrease by less than 1/16 px next to its ends.
class Strands {
 public:
  explicit Strands(const Cubic& curve);
  unsigned count() const { return count_; }
  Strand operator[](unsigned index) const;

 private:
  Cubic curve_;
  unsigned count_ = 1;
  std::uint16_t ends_[4];
};

// Walks one strand.
class StrandWalk {
 public:
  StrandWalk() = default;
  // Stands on the strand's first point. No step will be longer than 2^-fineness px in x or in y (1 px where fineness is
  // 0); finer ones are cut off at the finest level.
  StrandWalk(const Strand& strand, int fineness);

  CurvePoint at() const { return rest_ == 0 ? end_ : steps_.at(); }  // 28.4, cut off
  bool done() const { return rest_ == 0; }
  // To the next point; not after the last one.
  void next();

 private:
  StrandSteps steps_;
  CurvePoint end_;
  std::uint16_t rest_ = 0;  // to the end, in steps of the finest level
  std::uint8_t fineness_ = 0;
};

}  // namespace spanline
