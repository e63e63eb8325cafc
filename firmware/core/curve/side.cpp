#include "core/curve/side.hpp"

#include <bit>

#include "core/fx/root.hpp"

namespace spanline {
namespace {

std::uint32_t magnitude(std::int32_t v) { return static_cast<std::uint32_t>(v < 0 ? -v : v); }

// At least the length of (a, b), and at most 1.12 of it.
std::uint32_t octagon(std::uint32_t a, std::uint32_t b) { return a > b ? a + b / 2 : b + a / 2; }

// a / b in Q16, cut off; a < b.
std::uint32_t quotient(std::uint32_t a, std::uint32_t b) {
  const int up = std::countl_zero(a) < 16 ? std::countl_zero(a) : 16;
  return (a << up) / (b >> (16 - up));
}

}  // namespace

// A chord leaves its curve by at most max |f''| / (8 n n), and f'' is 6 times a second difference of the control
// points. On the screen, x / w bends with w too, as much as the point is off the centre: hence the terms in w.
std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view) {
  std::uint32_t farthest_off = 0, any = 0;
  std::int32_t nearest = p[0].w;
  for (const ClipPoint& point : p) {
    if (point.w < nearest) nearest = point.w;
    const std::uint32_t x = magnitude(point.x), y = magnitude(point.y);
    if (x > farthest_off) farthest_off = x;
    if (y > farthest_off) farthest_off = y;
    any |= x | y | magnitude(point.w);
  }
  if (nearest < view.near_w) nearest = view.near_w;
  // Guard bands off the centre, Q16.
  const auto near = static_cast<std::uint32_t>(nearest), reach = static_cast<std::uint32_t>(view.reach);
  std::uint32_t off = farthest_off < near ? quotient(farthest_off, near) : reach;
  if (off > reach) off = reach;

  // Without the last bits of what is beyond 27: second differences have 29 then, and all that is added to them 31.
  const int down = any >> 27 == 0 ? 0 : static_cast<int>(std::bit_width(any)) - 27;
  std::uint32_t bend = 0;
  for (int i = 0; i < 2; ++i) {
    const auto second = [&](std::int32_t ClipPoint::*axis) {
      return magnitude((p[i].*axis >> down) - 2 * (p[i + 1].*axis >> down) + (p[i + 2].*axis >> down));
    };
    const auto of_w = static_cast<std::uint32_t>(std::uint64_t{second(&ClipPoint::w)} * off >> 16);
    const std::uint32_t here = octagon(second(&ClipPoint::x) + of_w, second(&ClipPoint::y) + of_w);
    if (here > bend) bend = here;
  }
  // The least n with n * n >= bend * kBend / (nearest * tolerance), of which 18 bits and more are kept.
  constexpr std::uint32_t kBend = 6 * kGuardPx * kSubpixels / 8;
  static_assert(kMaxSteps * kMaxSteps == 1 << 12, "so the dividend has 12 bits more than the divisor");
  std::uint64_t whole = std::uint64_t{bend} * kBend, part = std::uint64_t{near >> down} * view.tolerance;
  if (whole >= part << 12) return kMaxSteps;
  const int excess = static_cast<int>(std::bit_width(part)) - 19;
  if (excess > 0) {
    whole >>= excess;
    part >>= excess;
  }
  const auto divisor = static_cast<std::uint32_t>(part);
  const std::uint32_t square = (static_cast<std::uint32_t>(whole) + divisor - 1) / divisor;
  return square <= 1 ? 1 : square_root(square - 1) + 1;
}

CurveParameter::CurveParameter(std::uint32_t index, std::uint32_t steps) : steps_(steps) {
  CHECK(index <= steps && steps >= 1 && steps <= kMaxSteps);
  const auto i = static_cast<std::int32_t>(index), rest = static_cast<std::int32_t>(steps - index);
  weight_[0] = rest * rest * rest;
  weight_[1] = 3 * rest * rest * i;
  weight_[2] = 3 * rest * i * i;
  weight_[3] = i * i * i;
}

}  // namespace spanline
