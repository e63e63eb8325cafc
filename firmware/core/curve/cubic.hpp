// Every kind of curve is walked as a cubic Bezier curve.
#pragma once

#include <cstdint>

#include "core/fx/bits.hpp"

namespace spanline {

// A point on the screen, 28.4 px, y down. 32 bits wide, because a Bezier control point may lie outside the points that
// it is made from.
struct CurvePoint {
  std::int32_t x = 0, y = 0;

  friend constexpr CurvePoint operator+(CurvePoint a, CurvePoint b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr CurvePoint operator*(std::int32_t k, CurvePoint a) { return {k * a.x, k * a.y}; }
  // To the nearest, halves upwards; divisor > 0.
  friend constexpr CurvePoint divided(CurvePoint a, std::int32_t divisor) {
    return {round_div(a.x, divisor), round_div(a.y, divisor)};
  }
  friend constexpr bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

// The same of a mesh, in mesh units.
struct SpacePoint {
  std::int32_t x = 0, y = 0, z = 0;

  friend constexpr SpacePoint operator+(SpacePoint a, SpacePoint b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr SpacePoint operator*(std::int32_t k, SpacePoint a) { return {k * a.x, k * a.y, k * a.z}; }
  friend constexpr SpacePoint divided(SpacePoint a, std::int32_t divisor) {
    return {round_div(a.x, divisor), round_div(a.y, divisor), round_div(a.z, divisor)};
  }
  friend constexpr bool operator==(const SpacePoint&, const SpacePoint&) = default;
};

inline constexpr std::int32_t kMaxCurve = 1 << 16;  // 28.4: control points lie within 4096 px of the screen's corner

// The control points of a cubic Bezier curve.
template <typename Point>
struct CubicOf {
  Point p[4];
};
using Cubic = CubicOf<CurvePoint>;

// The conversions take points that fit 16 bits and give control points on the same grid (1/16 px on the screen), each
// the nearest to the exact one, halves upwards. So the curve is within half a unit of the exact one in each coordinate,
// and pieces that share points of a spline meet in the same integers, seen from either side and in either direction.

// (a + weight * b) / (1 + weight)
template <typename Point>
constexpr Point between(Point a, Point b, std::int32_t weight) {
  return divided(a + weight * b, 1 + weight);
}

// The knot of a B-spline at b.
template <typename Point>
constexpr Point knot(Point a, Point b, Point c) {
  return divided(a + 4 * b + c, 6);
}

// From `at` a sixth of the way from `from` to `to`: a third of the tangent that Catmull and Rom give it.
template <typename Point>
constexpr Point along(Point at, Point from, Point to) {
  return divided(6 * at + to + -1 * from, 6);
}

// A quadratic Bezier curve, its degree raised.
template <typename Point>
constexpr CubicOf<Point> from_quadratic(Point p0, Point p1, Point p2) {
  return {{p0, between(p0, p1, 2), between(p2, p1, 2), p2}};
}

// The piece of a uniform cubic B-spline that the de Boor points a, b, c, d control: near b to near c.
template <typename Point>
constexpr CubicOf<Point> from_b_spline(Point a, Point b, Point c, Point d) {
  return {{knot(a, b, c), between(c, b, 2), between(b, c, 2), knot(b, c, d)}};
}

// The piece of a Catmull-Rom spline from b to c.
template <typename Point>
constexpr CubicOf<Point> from_catmull_rom(Point a, Point b, Point c, Point d) {
  return {{b, along(b, a, c), along(c, d, b), c}};
}

}  // namespace spanline
