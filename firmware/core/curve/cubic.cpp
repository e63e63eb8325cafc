#include "core/curve/cubic.hpp"

#include "core/fx/bits.hpp"

namespace spanline {
namespace {

CurvePoint nearest(std::int32_t x, std::int32_t y, std::int32_t divisor) {
  return {round_div(x, divisor), round_div(y, divisor)};
}

// (a + weight * b) / (1 + weight)
CurvePoint between(CurvePoint a, CurvePoint b, std::int32_t weight) {
  return nearest(a.x + weight * b.x, a.y + weight * b.y, 1 + weight);
}

// The knot of a B-spline at b.
CurvePoint knot(CurvePoint a, CurvePoint b, CurvePoint c) {
  return nearest(a.x + 4 * b.x + c.x, a.y + 4 * b.y + c.y, 6);
}

// From `at` a sixth of the way from `from` to `to`: a third of the tangent that Catmull and Rom give it.
CurvePoint along(CurvePoint at, CurvePoint from, CurvePoint to) {
  return nearest(6 * at.x + to.x - from.x, 6 * at.y + to.y - from.y, 6);
}

}  // namespace

Cubic from_quadratic(CurvePoint p0, CurvePoint p1, CurvePoint p2) {
  return {{p0, between(p0, p1, 2), between(p2, p1, 2), p2}};
}

Cubic from_b_spline(CurvePoint a, CurvePoint b, CurvePoint c, CurvePoint d) {
  return {{knot(a, b, c), between(c, b, 2), between(b, c, 2), knot(b, c, d)}};
}

Cubic from_catmull_rom(CurvePoint a, CurvePoint b, CurvePoint c, CurvePoint d) {
  return {{b, along(b, a, c), along(c, d, b), c}};
}

}  // namespace spanline
