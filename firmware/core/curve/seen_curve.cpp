#include "core/curve/seen_curve.hpp"

#include <bit>

#include "core/fx/length.hpp"

namespace spanline {

bool SeenPlaces::allow(const DiceView& view) const {
  constexpr std::int32_t kBorder = 1 << kProjectedBits;
  if (nearest < view.near_w || nearest <= 0 || farthest - nearest > nearest >> 1) return false;
  return places.low.x() > view.centre_x - kBorder && places.high.x() < view.centre_x + kBorder &&
         places.low.y() > view.centre_y - kBorder && places.high.y() < view.centre_y + kBorder;
}

int SeenPlaces::cut() const { return farthest >> (31 - kQuarterBits) == 0 ? 0 : kQuarterBits; }

SeenCurve::SeenCurve(const ClipPoint* p, const ScreenXY* at, int stride) {
  const PackedXY a(at[0]), b(at[stride]), c(at[2 * stride]), d(at[3 * stride]);
  second_[0] = {a.x() - 2 * b.x() + c.x(), a.y() - 2 * b.y() + c.y()};
  second_[1] = {b.x() - 2 * c.x() + d.x(), b.y() - 2 * c.y() + d.y()};
  for (int i = 0; i < 4; ++i) w_[i] = p[i * stride].w;
}

SeenCurve SeenCurve::quarter_way(const SeenCurve& a, const SeenCurve& b, const SeenCurve& c, const SeenCurve& d,
                                 int cut) {
  SeenCurve between;
  for (int i = 0; i < 2; ++i) {
    const auto second = [&](std::int32_t Second::*axis) {
      return sum_quarter_way(a.second_[i].*axis, b.second_[i].*axis, c.second_[i].*axis, d.second_[i].*axis) >>
             kQuarterBits;
    };
    between.second_[i] = {second(&Second::x), second(&Second::y)};
  }
  for (int i = 0; i < 4; ++i) {
    between.w_[i] =
        sum_quarter_way(a.w_[i] >> cut, b.w_[i] >> cut, c.w_[i] >> cut, d.w_[i] >> cut) >> (kQuarterBits - cut);
  }
  return between;
}

std::uint32_t SeenCurve::square_of_steps(const DiceView& view) const {
  const auto w = [this](int i) { return static_cast<std::uint32_t>(w_[i]); };
  constexpr int kBits = 14;  // of w, so that it is multiplied in 32 bits
  const int excess = 32 - kBits - std::countl_zero(w(0) | w(1) | w(2) | w(3)), down = excess > 0 ? excess : 0;
  const auto bend = [&](const Second& d, int end, int next, int farther) {
    const std::uint32_t from = w(end) >> down, to = w(farther) >> down;
    const std::uint32_t ahead = magnitude(static_cast<std::int32_t>(from + to - 2 * (w(next) >> down)));
    return larger(length_at_most(magnitude(d.x), magnitude(d.y)), ahead * view.depth / from) * to / from;
  };
  const std::uint32_t most = larger(bend(second_[0], 0, 1, 2), bend(second_[1], 3, 2, 1)) + 1;  // places are rounded
  return (3 * most + 4 * view.tolerance - 1) / (4 * view.tolerance);
}

}  // namespace spanline
