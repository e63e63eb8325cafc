// The step control of an adaptive walk (seed 3, 5.3 and 5.4; Lien, Shantz and Pratt 1987), over exact registers.
#pragma once

#include <cstdint>

#include "core/curve/basis.hpp"
#include "core/curve/cubic.hpp"

namespace spanline {

// A point that moves along a curve on the screen in steps of 2^-level, kFirstLevel … kFinest. Control points have
// kCoordinateBits, sign included, of which `kSubpixel` are fraction.
template <typename Int, int kCoordinateBits, int kFinest, int kSubpixel>
class AdaptiveSteps {
 public:
  using Format = CurveFormat<Int, kCoordinateBits, kFinest>;
  static constexpr Int kPixel = Int{1} << (Format::kFraction + kSubpixel);
  static constexpr int kWhole = 1 << kFinest;  // steps of the finest level

  AdaptiveSteps() = default;
  explicit AdaptiveSteps(const CurvePoint (&p)[4]) {
    Int x[4], y[4];
    for (int i = 0; i < 4; ++i) {
      x[i] = p[i].x;
      y[i] = p[i].y;
    }
    x_ = Format::start(x);
    y_ = Format::start(y);
  }

  // Where the point is, cut off to the control points' grid.
  CurvePoint at() const { return {whole(x_.b0), whole(y_.b0)}; }
  // A step in units of the finest level.
  int length() const { return 1 << (kFinest - level_); }

  // Halves the step until no part of the curve with these control points can be longer than `most` in x or in y (or to
  // the finest): |f'| is at most three times the longest leg. A walk must begin so: of a longer step the ends alone do
  // not tell how far the curve goes in between, of one that was doubled bit by bit they do.
  void settle(const CurvePoint (&p)[4], Int most) {
    std::int32_t leg = 0;
    const auto note = [&leg](std::int32_t d) { leg = d > leg ? d : -d > leg ? -d : leg; };
    for (int i = 0; i < 3; ++i) {
      note(p[i + 1].x - p[i].x);
      note(p[i + 1].y - p[i].y);
    }
    while (level_ < kFinest && (Int{3} * leg >> level_) >= most >> Format::kFraction) halve();
  }

  // Halves the step until it is at most `most` in x and in y (or the finest), then doubles it as often as it stays so
  // and `allowed(length of the doubled step)`. A doubled step is 2 * b1 + b2.
  template <typename Allowed>
  void fit(Int most, const Allowed& allowed) {
    while (level_ < kFinest && !within(x_.b1, y_.b1, most)) halve();
    while (level_ > kFirstLevel && allowed(2 * length()) && within((x_.b1 << 1) + x_.b2, (y_.b1 << 1) + y_.b2, most)) {
      x_.double_step();
      y_.double_step();
      --level_;
    }
  }
  void halve() {
    x_.halve();
    y_.halve();
    ++level_;
  }
  void step() {
    x_.step();
    y_.step();
  }

 private:
  static std::int32_t whole(Word<Int> b0) { return static_cast<std::int32_t>((b0 >> Format::kFraction).value()); }
  static bool within(Word<Int> x, Word<Int> y, Int most) {
    return x.value() <= most && x.value() >= -most && y.value() <= most && y.value() >= -most;
  }

  CurveBasis<Int> x_, y_;
  std::uint8_t level_ = kFirstLevel;
};

}  // namespace spanline
