// Random curves and the exact ones in floating point, for the tests of what walks and draws them.
#pragma once

#include "core/curve/cubic.hpp"
#include "oracle/random.hpp"

namespace spanline::test {

struct At {
  double x, y;  // px
};

inline At exact_at(const Cubic& c, double t) {
  const double s = 1 - t;
  const double w[4] = {s * s * s / 16, 3 * s * s * t / 16, 3 * s * t * t / 16, t * t * t / 16};
  At at{0, 0};
  for (int i = 0; i < 4; ++i) {
    at.x += w[i] * c.p[i].x;
    at.y += w[i] * c.p[i].y;
  }
  return at;
}

inline CurvePoint random_point(oracle::Random& random, int width, int height) {
  return {random.below(width * 16), random.below(height * 16)};
}

// On a screen of that many pixels.
inline Cubic random_cubic(oracle::Random& random, int width = 320, int height = 240) {
  Cubic curve;
  for (CurvePoint& p : curve.p) p = random_point(random, width, height);
  return curve;
}

// As far off as curves may be.
inline Cubic random_far_cubic(oracle::Random& random) {
  Cubic curve;
  for (CurvePoint& p : curve.p) {
    p = {random.between(-kMaxCurve, kMaxCurve), random.between(-kMaxCurve, kMaxCurve)};
    if (random.percent(30)) p = {random.percent(50) ? kMaxCurve : -kMaxCurve, p.y};
  }
  return curve;
}

}  // namespace spanline::test
