#include "core/curve/steps.hpp"

#include <bit>

#include "core/fx/root.hpp"

namespace spanline {
namespace {

constexpr int kProjectedBits = 14;  // of a place in 28.4 px, in guard bands

std::uint32_t magnitude(std::int32_t v) { return static_cast<std::uint32_t>(v < 0 ? -v : v); }
std::uint32_t larger(std::uint32_t a, std::uint32_t b) { return a > b ? a : b; }

// At least the length of (a, b), and at most 1.02 of it: the norm of a polygon of 16 corners on the circle. a, b <
// 2^30.
std::uint32_t length_at_most(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t most = larger(a, b), least = a ^ b ^ most;
  return larger(most + (least >> 6) * 13 + 13, most - (most >> 6) * 10 + (least >> 6) * 37 + 37);
}

}  // namespace

ScreenPlace::ScreenPlace(const ClipPoint& p, const DiceView& view) {
  if (p.w < view.near_w || p.w <= 0) return;
  const auto w = static_cast<std::uint32_t>(p.w);
  const int up = std::countl_zero(w) - 1;
  const auto inverse = static_cast<std::int32_t>(reciprocal_normalised(w << up));  // of 2^61
  const auto place = [&](std::int32_t v) {
    // What lies beyond the screen's border is not seen.
    if (magnitude(v) >= w) return v < 0 ? -view.reach : view.reach;
    const std::int32_t at = mul_high(v * (1 << up), inverse), limit = view.reach >> 2;  // Q1.29
    return at < -limit ? -view.reach : at > limit ? view.reach : at * 4;
  };
  x = place(p.x);
  y = place(p.y);
}

ScreenPlace::ScreenPlace(ScreenXY at, const DiceView& view) {
  if (at.x == kNotProjected.x) return;
  static_assert(kGuardPx * kSubpixels == 1 << kProjectedBits);
  constexpr int kUp = 31 - kProjectedBits;
  const std::int32_t limit = view.reach >> kUp;
  const auto place = [&](std::int32_t v) { return (v < -limit ? -limit : v > limit ? limit : v) * (1 << kUp); };
  x = place(at.x - view.centre_x);
  y = place(at.y - view.centre_y);
}

PlaceBounds::PlaceBounds(const ScreenPlace* place, int count, int stride, const DiceView& view) {
  for (int i = 0; i < count; ++i, place += stride) {
    if (place->x < x.low) x.low = place->x;
    if (place->x > x.high) x.high = place->x;
    if (place->y < y.low) y.low = place->y;
    if (place->y > y.high) y.high = place->y;
  }
  static_assert(ScreenPlace::kAnywhere == INT32_MIN);
  if (x.low == ScreenPlace::kAnywhere) x = y = {-view.reach, view.reach};
  // Half a unit of a projected point; the reciprocal's 2^-25 of one, and what is cut off.
  constexpr std::int32_t kError = (1 << (30 - kProjectedBits)) + (1 << 8);
  x = {x.low - kError, x.high + kError};
  y = {y.low - kError, y.high + kError};
}

std::uint32_t Bend::steps(const DiceView& view) const {
  // The least n with n * n >= bend * kBend / (nearest * tolerance), of which 18 bits and more are kept.
  constexpr std::uint32_t kBend = 6 * kGuardPx * kSubpixels / 8;
  static_assert(kMaxSteps * kMaxSteps == 1 << 12, "so the dividend has 12 bits more than the divisor");
  std::uint64_t whole = std::uint64_t{bend} * kBend, part = std::uint64_t{nearest} * view.tolerance;
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

CurveBend::CurveBend(const ClipPoint* p, int stride, const CurveReach& reach, const PlaceBounds& bounds, int down,
                     const DiceView& view) {
  for (int i = 0; i < 2; ++i, p += stride) {
    const auto second = [&](std::int32_t ClipPoint::*axis) {  // of 29 bits
      const auto at = [&](int j) { return p[j * stride].*axis >> down; };
      return at(0) - 2 * at(1) + at(2);
    };
    const std::int32_t x = second(&ClipPoint::x), y = second(&ClipPoint::y), w = second(&ClipPoint::w);
    const auto off = [w](std::int32_t d, std::int32_t place) { return d - 2 * mul_high(w, place); };
    off_[i] = {off(x, bounds.x.low), off(x, bounds.x.high), off(y, bounds.y.low), off(y, bounds.y.high)};
  }
  const std::int32_t nearest = (reach.nearest() < view.near_w ? view.near_w : reach.nearest()) >> down;
  nearest_ = nearest < 1 ? 1 : static_cast<std::uint32_t>(nearest);
}

void CurveBend::go_halfway(const CurveBend& other) {
  const auto go = [](std::int32_t& from, std::int32_t to) { from = (from + to) >> 1; };
  for (int i = 0; i < 2; ++i) {
    auto& off = off_[i];
    const auto& to = other.off_[i];
    go(off.x_low, to.x_low);
    go(off.x_high, to.x_high);
    go(off.y_low, to.y_low);
    go(off.y_high, to.y_high);
  }
  nearest_ = (nearest_ + other.nearest_) >> 1;
}

Bend CurveBend::bend() const {
  constexpr std::uint32_t kCutOff = 2 + 3 + 1;  // by mul_high(), by go_halfway() three times over, and here
  const auto most = [](std::int32_t low, std::int32_t high) {
    return larger(static_cast<std::uint32_t>(low ^ low >> 31), static_cast<std::uint32_t>(high ^ high >> 31)) + kCutOff;
  };
  std::uint32_t bend = 0;
  for (const auto& d : off_) bend = larger(bend, length_at_most(most(d.x_low, d.x_high), most(d.y_low, d.y_high)));
  return {bend, nearest_};
}

std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view) {
  const ScreenPlace place[4] = {{p[0], view}, {p[1], view}, {p[2], view}, {p[3], view}};
  const CurveReach reach(p);
  return CurveBend(p, 1, reach, {place, 4, 1, view}, reach.beyond_27_bits(), view).bend().steps(view);
}

}  // namespace spanline
