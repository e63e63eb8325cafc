#include "core/curve/steps.hpp"

#include <bit>

#include "core/curve/seen_curve.hpp"
#include "core/fx/length.hpp"

namespace spanline {

PlaceBounds::PlaceBounds(const PackedBox& places, const DiceView& view) {
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

namespace {

// bend / nearest is how far a curve's second differences bend it on the screen, in guard bands. bend < 2^31, nearest
// from 1 to 2^31.
std::uint32_t square_of(std::uint32_t bend, std::uint32_t nearest, std::uint32_t tolerance) {
  // The least square that is bend * kBend / (nearest * tolerance) or more, of which 18 bits and more are kept.
  constexpr std::uint32_t kBend = 6 * kGuardPx * kSubpixels / 8;
  static_assert(kMaxSteps * kMaxSteps == 1 << 12, "so the dividend has 12 bits more than the divisor");
  std::uint64_t whole = std::uint64_t{bend} * kBend, part = std::uint64_t{nearest} * tolerance;
  if (whole >= part << 12) return kMaxSteps * kMaxSteps;
  const int excess = static_cast<int>(std::bit_width(part)) - 19;
  if (excess > 0) {
    whole >>= excess;
    part >>= excess;
  }
  const auto divisor = static_cast<std::uint32_t>(part);
  return (static_cast<std::uint32_t>(whole) + divisor - 1) / divisor;
}

// The length of a second difference on the screen where it is the most.
std::uint32_t off_screen_place(std::int32_t x, std::int32_t y, std::int32_t w, const PlaceBounds& bounds) {
  constexpr std::int32_t kCutOff = 3;  // by add_high()
  // Of d - p * w the most is where p is at that end of its bounds that adds to what it is in the middle.
  const auto most = [w](std::int32_t d, const PlaceBounds::Range& p) {
    const std::int32_t middle = add_high(2 * w, p.middle, d);
    return static_cast<std::uint32_t>(add_high(2 * (w ^ w >> 31) + 1, p.half, (middle ^ middle >> 31) + kCutOff));
  };
  constexpr int kDown = 5;
  return length_at_most((most(x, bounds.x) >> kDown) + 1, (most(y, bounds.y) >> kDown) + 1) << kDown;
}

}  // namespace

std::uint32_t square_of_steps_at_most(const ClipPoint* p, int stride, const PlaceBounds& bounds, int down,
                                      const DiceView& view) {
  std::uint32_t bend = 0;
  for (int i = 0; i < 2; ++i) {
    const ClipPoint &a = p[i * stride], &b = p[(i + 1) * stride], &c = p[(i + 2) * stride];
    const auto second = [&](std::int32_t ClipPoint::*axis) {
      return (a.*axis >> down) - 2 * (b.*axis >> down) + (c.*axis >> down);  // of 29 bits
    };
    bend = larger(bend, off_screen_place(second(&ClipPoint::x), second(&ClipPoint::y), second(&ClipPoint::w), bounds));
  }
  std::int32_t nearest = INT32_MAX;
  for (int i = 0; i < 4; ++i) nearest = p[i * stride].w < nearest ? p[i * stride].w : nearest;
  nearest = (nearest < view.near_w ? view.near_w : nearest) >> down;
  return square_of(bend, nearest < 1 ? 1u : static_cast<std::uint32_t>(nearest), view.tolerance);
}

std::uint32_t steps_of(std::uint32_t square) {
  std::uint32_t steps = 1;
  while (steps * steps < square && steps < kMaxSteps) ++steps;
  return steps;
}

std::uint32_t square_of_steps(const ClipPoint* p, const ScreenXY* at, int stride, const DiceView& view) {
  SeenPlaces seen;
  for (int i = 0; i < 4; ++i) seen.widen(at[i * stride], p[i * stride].w);
  if (seen.allow(view)) return SeenCurve(p, at, stride).square_of_steps(view);
  const int down = CurveReach(p, stride).beyond_27_bits();
  return square_of_steps_at_most(p, stride, PlaceBounds(seen.places, view), down, view);
}

std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view) {
  ScreenXY at[4];
  for (int i = 0; i < 4; ++i) at[i] = place_on_screen(p[i], view);
  return steps_of(square_of_steps(p, at, 1, view));
}

}  // namespace spanline
