// Curves on the screen: every kind is walked as a cubic Bezier curve.
#pragma once

#include <cstdint>

namespace spanline {

// A point on the screen, 28.4 px, y down. 32 bits wide, because a Bezier control point may lie outside the points that
// it is made from.
struct CurvePoint {
  std::int32_t x = 0, y = 0;
  friend constexpr bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

inline constexpr std::int32_t kMaxCurve = 1 << 16;  // 28.4: control points lie within 4096 px of the screen's corner

struct Cubic {
  CurvePoint p[4];
};

// The conversions take points that fit 28.4 in 16 bits and give control points on the 1/16 px grid, each the nearest to
// the exact one, halves upwards. So the curve is within 1/32 px of the exact one in x and in y, and pieces that share
// points of a spline meet in the same integers, seen from either side and in either direction.

// A quadratic Bezier curve, its degree raised.
Cubic from_quadratic(CurvePoint p0, CurvePoint p1, CurvePoint p2);

// The piece of a uniform cubic B-spline that the de Boor points a, b, c, d control: near b to near c.
Cubic from_b_spline(CurvePoint a, CurvePoint b, CurvePoint c, CurvePoint d);

// The piece of a Catmull-Rom spline from b to c.
Cubic from_catmull_rom(CurvePoint a, CurvePoint b, CurvePoint c, CurvePoint d);

}  // namespace spanline
