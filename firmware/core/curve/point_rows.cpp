#include "core/curve/point_rows.hpp"

#include <array>

#include "core/fx/bits.hpp"

namespace spanline {
namespace {

// 2^31 / n; of 1 what a word holds.
constexpr auto kInverses = [] {
  std::array<std::int32_t, kMostPieceSteps + 1> inverses{};
  for (std::int64_t n = 1; n <= kMostPieceSteps; ++n) {
    inverses[static_cast<std::size_t>(n)] = saturate32(((std::int64_t{1} << 31) + n / 2) / n);
  }
  return inverses;
}();

}  // namespace

// With f = p0 + a1 t + a2 t^2 + a3 t^3 and h = 1 / n: b1 = ((a3 h + a2) h + a1) h, b2 = (6 a3 h + 2 a2) h h,
// b3 = 6 a3 h h h. A leg is at most kMostPieceSteps / 3 px, so a3 is at most 6 of them and 6 * a3 within 2^28 px units.
CurveBasis<std::int32_t> piece_basis(const std::int32_t (&p)[4], std::uint32_t n) {
  const std::int32_t inverse = kInverses[n];
  const auto over_n = [inverse](std::int32_t v) {
    return static_cast<std::int32_t>(shift_round(std::int64_t{2 * v} * inverse, 32));  // |v| < 2^30
  };
  const std::int32_t a1 = 3 * (p[1] - p[0]), a2 = 3 * ((p[2] - p[1]) - (p[1] - p[0])),
                     a3 = p[3] - p[0] + 3 * (p[1] - p[2]);
  const std::int32_t six = over_n(6 * a3);
  using W = Word<std::int32_t>;
  return {W(p[0]), W(over_n(a1 + over_n(a2 + over_n(a3)))), W(over_n(over_n(2 * a2 + six))), W(over_n(over_n(six)))};
}

PointRows::PointRows(const ScreenPiece& piece) : count_(piece.columns) {
  for (int axis = 0; axis < kPointAxes; ++axis) {
    for (int j = 0; j < 4; ++j) {
      const auto& at = piece.at[axis];
      columns_[axis][j] = piece_basis({at[0][j], at[1][j], at[2][j], at[3][j]}, piece.rows);
    }
  }
}

void PointRows::step() {
  for (auto& axis : columns_) {
    for (auto& column : axis) column.step();
  }
}

bool PointRows::meets(const PointWindow& window) const {
  std::int32_t top = INT32_MAX, bottom = INT32_MIN;
  for (int j = 0; j < 4; ++j) {
    const std::int32_t y = control(kPointY, j);
    top = y < top ? y : top;
    bottom = y > bottom ? y : bottom;
  }
  // What rounding may add is less than the 16th of a pixel that is added here.
  constexpr std::int32_t kRounding = 1 << (kPointBits - 4);
  return ((bottom + kRounding) >> kPointBits) >= window.top && ((top - kRounding) >> kPointBits) < window.bottom;
}

// 6 times a derivative over the steps is 6 b1 - 3 b2 + 2 b3.
void PointRows::turns(std::int32_t* out) const {
  const auto slope = [](const CurveBasis<std::int32_t>& b) {
    return (6 * b.b1.value() - 3 * b.b2.value() + 2 * b.b3.value()) >> (kPointBits - 10);
  };
  constexpr int kUp = kPointBits - 10;
  CurveBasis<std::int32_t> walk[2], across[2];
  for (int axis = kPointX; axis <= kPointY; ++axis) {
    const auto& c = columns_[axis];
    walk[axis] = piece_basis({c[0].b0.value(), c[1].b0.value(), c[2].b0.value(), c[3].b0.value()}, count_);
    across[axis] =
        piece_basis({slope(c[0]) << kUp, slope(c[1]) << kUp, slope(c[2]) << kUp, slope(c[3]) << kUp}, count_);
  }
  for (std::uint32_t i = 0;; ++i) {
    const std::int32_t x = slope(walk[kPointX]), y = slope(walk[kPointY]);
    out[i] = x * (across[kPointY].b0.value() >> kUp) - y * (across[kPointX].b0.value() >> kUp);
    if (i == count_) return;
    for (int axis = kPointX; axis <= kPointY; ++axis) {
      walk[axis].step();
      across[axis].step();
    }
  }
}

void PointRows::step_off(PointPixel* out) const {
  CurveBasis<std::int32_t> walk[kPointAxes];
  for (int axis = 0; axis < kPointAxes; ++axis) {
    const auto& c = columns_[axis];
    walk[axis] = piece_basis({c[0].b0.value(), c[1].b0.value(), c[2].b0.value(), c[3].b0.value()}, count_);
  }
  CurveBasis<std::int32_t> x = walk[kPointX], y = walk[kPointY], depth = walk[kPointDepth];
  for (PointPixel* const end = out + count_;; ++out) {
    *out = {static_cast<std::int16_t>(x.b0.value() >> kPointBits),
            static_cast<std::int16_t>(y.b0.value() >> kPointBits), depth.b0.value()};
    if (out == end) return;
    x.step();
    y.step();
    depth.step();
  }
}

}  // namespace spanline
