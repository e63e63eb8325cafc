#include "core/curve/walk.hpp"

#include "core/base/check.hpp"
#include "core/fx/bits.hpp"

namespace spanline {
namespace {

bool within(std::int32_t x, std::int32_t y, std::int32_t most) {
  return x <= most && x >= -most && y <= most && y >= -most;
}

// De Casteljau's points at 1/2 in one coordinate, each rounded from the exact sum: the same from either end.
void cut_coordinate(CurvePoint (&left)[4], CurvePoint (&right)[4], std::int32_t CurvePoint::*c) {
  const std::int32_t p0 = left[0].*c, p1 = left[1].*c, p2 = left[2].*c, p3 = left[3].*c;
  left[1].*c = shift_round(p0 + p1, 1);
  left[2].*c = shift_round(p0 + 2 * p1 + p2, 2);
  left[3].*c = right[0].*c = shift_round(p0 + 3 * (p1 + p2) + p3, 3);
  right[1].*c = shift_round(p1 + 2 * p2 + p3, 2);
  right[2].*c = shift_round(p2 + p3, 1);
  right[3].*c = p3;
}

}  // namespace

CurveWalk::CurveWalk(const Cubic& curve) {
  constexpr std::int32_t kFiner = 1 << (kSubpixel - 4);
  for (int i = 0; i < 4; ++i) {
    CHECK(within(curve.p[i].x, curve.p[i].y, kMaxCurve));
    waiting_[0].p[i] = {curve.p[i].x * kFiner, curve.p[i].y * kFiner};
  }
}

bool CurveWalk::short_enough(const Piece& piece) {
  for (int i = 0; i < 3; ++i) {
    const CurvePoint from = piece.p[i], to = piece.p[i + 1];
    if (!within(3 * (to.x - from.x), 3 * (to.y - from.y), kLongestLegs)) return false;
  }
  return true;
}

CurveWalk::Piece CurveWalk::cut(Piece& piece) {
  Piece right;
  cut_coordinate(piece.p, right.p, &CurvePoint::x);
  cut_coordinate(piece.p, right.p, &CurvePoint::y);
  return right;
}

// Makes the next piece current; false where there is none.
bool CurveWalk::next_piece() {
  if (waiting_count_ == 0) return false;
  Piece piece = waiting_[--waiting_count_];
  while (!short_enough(piece)) {
    CHECK(waiting_count_ <= kMaxCuts);
    waiting_[waiting_count_++] = cut(piece);
  }
  origin_ = piece.p[0];
  for (CurvePoint& p : piece.p) p = {p.x - origin_.x, p.y - origin_.y};
  steps_ = Steps(piece.p);
  steps_.settle(piece.p, Steps::kPixel);
  rest_ = Steps::kWhole;
  return true;
}

CurvePixel CurveWalk::pixel() const {
  const CurvePoint at = steps_.at();
  return {static_cast<std::int16_t>((origin_.x + at.x) >> kSubpixel),
          static_cast<std::int16_t>((origin_.y + at.y) >> kSubpixel)};
}

bool CurveWalk::next(CurvePixel& out) {
  const bool first = points_ == 0;
  do {
    if (rest_ == 0 && !next_piece()) return false;
    if (!first) {
      // A step may be doubled only at its own multiples, so that the last one ends the piece.
      steps_.fit(Steps::kPixel, [this](int doubled) { return (rest_ & (doubled - 1)) == 0; });
      steps_.step();
      rest_ -= steps_.length();
    }
    ++points_;
    out = pixel();
  } while (!first && out == last_);
  last_ = out;
  return true;
}

}  // namespace spanline
