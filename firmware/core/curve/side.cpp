#include "core/curve/side.hpp"

#include <array>
#include <bit>

#include "core/fx/root.hpp"

namespace spanline {
namespace {

std::int64_t magnitude(std::int64_t v) { return v < 0 ? -v : v; }

// At least the length of (a, b), and at most 1.12 of it.
std::int64_t octagon(std::int64_t a, std::int64_t b) { return a > b ? a + b / 2 : b + a / 2; }

// 1 / n^3 as factor / 2^(30 + shift), factor in [2^30, 2^31).
struct Cube {
  std::int32_t factor;
  std::uint8_t shift;
};
constexpr auto kCubes = [] {
  std::array<Cube, kMaxSteps + 1> cubes{};
  for (std::uint32_t n = 2; n <= kMaxSteps; ++n) {
    const std::uint32_t cube = n * n * n;
    const auto shift = static_cast<int>(std::bit_width(cube - 1));
    const std::uint64_t factor = ((std::uint64_t{1} << (30 + shift)) + cube / 2) / cube;
    cubes[n] = {static_cast<std::int32_t>(factor), static_cast<std::uint8_t>(shift)};
  }
  return cubes;
}();
static_assert(kCubes[2].factor == 1 << 30 && kCubes[kMaxSteps].shift <= 18);

// n^3 * v to v, rounded twice; n at least 2. n^3 <= 2^shift, so the first quotient is no longer than v.
std::int32_t divided_by_cube(std::int64_t scaled, const Cube& cube) {
  const auto sum = static_cast<std::uint64_t>(scaled) + (std::uint32_t{1} << (cube.shift - 1));
  const std::uint32_t quotient = static_cast<std::uint32_t>(sum) >> cube.shift | static_cast<std::uint32_t>(sum >> 32)
                                                                                     << (32 - cube.shift);
  return saturate32(shift_round(std::int64_t{static_cast<std::int32_t>(quotient)} * cube.factor, 30));
}

// The differences of n^3 * f at steps of 1 / n.
CurveBasis<std::int64_t> scaled_basis(const ClipPoint (&p)[4], std::int32_t ClipPoint::*axis, std::int64_t n) {
  const std::int64_t p0 = p[0].*axis, p1 = p[1].*axis, p2 = p[2].*axis, p3 = p[3].*axis;
  const std::int64_t a1 = 3 * (p1 - p0), a2 = 3 * (p0 - 2 * p1 + p2), a3 = p3 - p0 + 3 * (p1 - p2);
  using W = Word<std::int64_t>;
  return {W(n * n * n * p0), W((a1 * n + a2) * n + a3), W(2 * a2 * n + 6 * a3), W(6 * a3)};
}

}  // namespace

// A chord leaves its curve by at most max |f''| / (8 n n), and f'' is 6 times a second difference of the control
// points. On the screen, x / w bends with w too, as much as the point is off the centre: hence the terms in w.
std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view) {
  std::int64_t nearest = p[0].w, farthest_off = 0;
  for (const ClipPoint& point : p) {
    if (point.w < nearest) nearest = point.w;
    for (const std::int64_t v : {point.x, point.y}) {
      if (magnitude(v) > farthest_off) farthest_off = magnitude(v);
    }
  }
  if (nearest < view.near_w) nearest = view.near_w;
  std::int64_t off = (farthest_off << 16) / nearest;  // Q16 guard bands off the centre
  if (off > view.reach) off = view.reach;

  std::int64_t bend = 0;
  for (int i = 0; i < 2; ++i) {
    const auto second = [&](std::int32_t ClipPoint::*axis) {
      return magnitude(std::int64_t{p[i].*axis} - 2 * std::int64_t{p[i + 1].*axis} + p[i + 2].*axis);
    };
    const std::int64_t of_w = second(&ClipPoint::w) * off >> 16;
    const std::int64_t here = octagon(second(&ClipPoint::x) + of_w, second(&ClipPoint::y) + of_w);
    if (here > bend) bend = here;
  }
  const std::int64_t tolerance = nearest * view.tolerance;
  const std::int64_t square = (bend * (6 * kGuardPx * kSubpixels / 8) + tolerance - 1) / tolerance;
  if (square >= std::int64_t{kMaxSteps} * kMaxSteps) return kMaxSteps;
  return square <= 1 ? 1 : square_root(static_cast<std::uint32_t>(square) - 1) + 1;
}

CurveParameter::CurveParameter(std::uint32_t index, std::uint32_t steps) : steps_(steps) {
  CHECK(index <= steps && steps >= 1 && steps <= kMaxSteps);
  const auto i = static_cast<std::int32_t>(index), rest = static_cast<std::int32_t>(steps - index);
  weight_[0] = rest * rest * rest;
  weight_[1] = 3 * rest * rest * i;
  weight_[2] = 3 * rest * i * i;
  weight_[3] = i * i * i;
}

ClipPoint CurveParameter::of(const ClipPoint& p0, const ClipPoint& p1, const ClipPoint& p2, const ClipPoint& p3) const {
  if (weight_[3] == 0) return p0;
  if (weight_[0] == 0) return p3;
  const Cube& cube = kCubes[steps_];
  const auto at = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    const std::int64_t sum = std::int64_t{weight_[0]} * a + std::int64_t{weight_[1]} * b +
                             std::int64_t{weight_[2]} * c + std::int64_t{weight_[3]} * d;
    return divided_by_cube(sum, cube);
  };
  return {at(p0.x, p1.x, p2.x, p3.x), at(p0.y, p1.y, p2.y, p3.y), at(p0.w, p1.w, p2.w, p3.w)};
}

SideWalk::SideWalk(const ClipPoint (&p)[4], std::uint32_t steps)
    : x_(scaled_basis(p, &ClipPoint::x, steps)),
      y_(scaled_basis(p, &ClipPoint::y, steps)),
      w_(scaled_basis(p, &ClipPoint::w, steps)),
      first_(p[0]),
      last_(p[3]),
      steps_(steps) {
  CHECK(steps >= 1 && steps <= kMaxSteps);
}

ClipPoint SideWalk::at() const {
  if (index_ == 0) return first_;
  if (index_ == steps_) return last_;
  const Cube& cube = kCubes[steps_];
  return {divided_by_cube(x_.b0.value(), cube), divided_by_cube(y_.b0.value(), cube),
          divided_by_cube(w_.b0.value(), cube)};
}

void SideWalk::step() {
  CHECK(index_ < steps_);
  ++index_;
  x_.step();
  y_.step();
  w_.step();
}

}  // namespace spanline
