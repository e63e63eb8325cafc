// The adaptive walk along a curve: a stream of pixels (seed 3, 5.3 and 5.4).
#pragma once

#include <cstdint>

#include "core/curve/adaptive_steps.hpp"

namespace spanline {

struct CurvePixel {
  std::int16_t x = 0, y = 0;  // px
  friend constexpr bool operator==(const CurvePixel&, const CurvePixel&) = default;
};

// Walks one curve from its first control point to its last. The pixels that come out are those that hold the points of
// the walk: neighbours touch by a side or a corner, and no pixel comes twice in a row. They may lie outside the screen.
//
// Steps are halved until they are at most a pixel in x and in y, and doubled as soon as they stay so. A curve that
// would need more than 64 steps is cut into halves first (Klassen 1994), whose control points lie on a 1/64 px grid: a
// cut moves the curve by 1/128 px at most, and the halves meet in the same integer. Then all steps are exact.
class CurveWalk {
 public:
  // Control points within kMaxCurve.
  explicit CurveWalk(const Cubic& curve);

  // The next pixel; false after the last.
  bool next(CurvePixel& pixel);

  // Points computed until now: over the distinct pixels this is the redundancy.
  std::uint32_t points() const { return points_; }

 private:
  static constexpr int kFinest = 6;    // levels; 2^6 steps
  static constexpr int kSubpixel = 6;  // fraction bits of a piece's control points
  // Three times the largest control leg is the longest that a curve can step: at most 2^kFinest px, so that steps at
  // the finest level are at most a pixel; the three legs together then keep a piece within as much of its first point.
  static constexpr std::int32_t kLongestLegs = std::int32_t{1} << (kFinest + kSubpixel);
  using Steps = AdaptiveSteps<std::int32_t, kFinest + kSubpixel + 1, kFinest, kSubpixel>;

  // Legs of 2 * kMaxCurve are halved, and rounded by a unit at most, until three of them are within kLongestLegs.
  static constexpr int kMaxCuts = 9;
  static_assert(3 * (((2 * kMaxCurve) << (kSubpixel - 4) >> kMaxCuts) + 2) <= kLongestLegs);

  struct Piece {
    CurvePoint p[4];  // kSubpixel fraction bits
  };
  static bool short_enough(const Piece& piece);
  static Piece cut(Piece& piece);  // leaves the first half, returns the second

  bool next_piece();
  CurvePixel pixel() const;

  Piece waiting_[kMaxCuts + 1];  // the last one is walked next
  unsigned waiting_count_ = 1;
  CurvePoint origin_;  // the first point of the current piece, from which its registers count
  Steps steps_;
  int rest_ = 0;  // of the current piece, in steps of the finest level
  CurvePixel last_;
  std::uint32_t points_ = 0;
};

}  // namespace spanline
