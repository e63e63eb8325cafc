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

ScreenXY place_on_screen(const ClipPoint& p, const DiceView& view) {
  if (p.w < view.near_w || p.w <= 0) return kNotProjected;
  const auto w = static_cast<std::uint32_t>(p.w);
  const int up = std::countl_zero(w) - 1;
  const auto inverse = static_cast<std::int32_t>(reciprocal_normalised(w << up));  // of 2^61
  const auto place = [&](std::int32_t v, std::int32_t centre) {
    constexpr std::int32_t kBorder = kGuardPx * kSubpixels;
    const std::int32_t off = magnitude(v) >= w ? (v < 0 ? -kBorder : kBorder)
                                               : shift_round(mul_high(v * (1 << up), inverse), 29 - kProjectedBits);
    return static_cast<std::int16_t>(centre + off);
  };
  return {place(p.x, view.centre_x), place(p.y, view.centre_y)};
}

PlaceBounds::PlaceBounds(const PackedBox& places, const DiceView& view) {
  static_assert(kGuardPx * kSubpixels == 1 << kProjectedBits);
  constexpr int kUp = 31 - kProjectedBits;
  // Half a unit of a projected point; the reciprocal's 2^-25 of one.
  constexpr std::int32_t kError = (1 << (kUp - 1)) + (1 << 8);
  // What lies beyond the screen's border is not seen.
  const std::int32_t limit = view.reach >> kUp;
  const bool anywhere = places.low.x() == kNotProjected.x;
  const auto range = [&](std::int32_t low, std::int32_t high, std::int32_t centre) -> Range {
    low = anywhere || low < centre - limit ? -limit : low > centre + limit ? limit : low - centre;
    high = anywhere || high > centre + limit ? limit : high < centre - limit ? -limit : high - centre;
    return {(low + high) * -(1 << (kUp - 1)), (high - low) * (1 << (kUp - 1)) + kError};
  };
  x = range(places.low.x(), places.high.x(), view.centre_x);
  y = range(places.low.y(), places.high.y(), view.centre_y);
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

CurveBend::CurveBend(const ClipPoint* p, int stride, const PlaceBounds& bounds, int down, const DiceView& view) {
  const ClipPoint &p0 = p[0], &p1 = p[stride], &p2 = p[2 * stride], &p3 = p[3 * stride];
  struct Pair {
    std::int32_t first, second;  // differences, of 29 bits
  };
  const auto second = [](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    return Pair{a - 2 * b + c, b - 2 * c + d};
  };
  const std::int32_t w0 = p0.w >> down, w1 = p1.w >> down, w2 = p2.w >> down, w3 = p3.w >> down;
  const std::int32_t near_w = view.near_w >> down;
  const auto less = [](std::int32_t a, std::int32_t b) { return a < b ? a : b; };
  const std::int32_t nearest = less(less(w0, w1), less(w2, w3));
  nearest_ = nearest < near_w ? near_w : nearest;
  if (nearest_ < 1) nearest_ = 1;
  const Pair w = second(w0, w1, w2, w3);
  const Pair x = second(p0.x >> down, p1.x >> down, p2.x >> down, p3.x >> down);
  const Pair y = second(p0.y >> down, p1.y >> down, p2.y >> down, p3.y >> down);
  const auto off = [&bounds](std::int32_t dx, std::int32_t dy, std::int32_t twice_dw) {
    return Off{add_high(twice_dw, bounds.x.middle, dx), add_high(twice_dw, bounds.y.middle, dy), twice_dw};
  };
  off_[0] = off(x.first, y.first, 2 * w.first);
  off_[1] = off(x.second, y.second, 2 * w.second);
}

void CurveBend::go_halfway(const CurveBend& other) {
  const auto go = [](std::int32_t& from, std::int32_t to) { from = (from + to) >> 1; };
  for (int i = 0; i < 2; ++i) {
    go(off_[i].x, other.off_[i].x);
    go(off_[i].y, other.off_[i].y);
    go(off_[i].w, other.off_[i].w);
  }
  go(nearest_, other.nearest_);
}

Bend CurveBend::bend(const PlaceBounds& bounds) const {
  constexpr std::int32_t kCutOff = 6;  // by add_high(), by go_halfway() three times over, and here
  // Of d - p * d.w the most is where p is at that end of its bounds that adds to what it is in the middle.
  const auto most = [](std::int32_t d, std::int32_t w, std::int32_t half) {
    return static_cast<std::uint32_t>(add_high(w ^ w >> 31, half, (d ^ d >> 31) + kCutOff));
  };
  const auto length = [&](const Off& d) {
    return length_at_most(most(d.x, d.w, bounds.x.half), most(d.y, d.w, bounds.y.half));
  };
  return {larger(length(off_[0]), length(off_[1])), static_cast<std::uint32_t>(nearest_)};
}

std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view) {
  PackedBox places;
  for (const ClipPoint& point : p) places.widen(PackedXY(place_on_screen(point, view)));
  const PlaceBounds bounds(places, view);
  return CurveBend(p, 1, bounds, CurveReach(p).beyond_27_bits(), view).bend(bounds).steps(view);
}

}  // namespace spanline
