#include "shapes.hpp"

namespace spanline::make {

namespace {

Vec knot(double t) {
  const double radius = 1 + 0.42 * std::cos(3 * t);
  return {radius * std::cos(2 * t), radius * std::sin(2 * t), 0.42 * std::sin(3 * t)};
}

Vec tangent(double t) {
  constexpr double kStep = 1e-4;
  return unit(knot(t + kStep) - knot(t - kStep));
}

}  // namespace

Mesh torus_knot(int along, int around) {
  constexpr double kTube = 0.2;
  // The frame leans on the direction from the torus's core circle to the knot: it closes without a twist.
  const auto corner = [&](int i, int j) -> Mesh::Corner {
    const double t = 2 * kPi * (i % along) / along;
    const double phi = 2 * kPi * (j % around) / around;
    const Vec core = {std::cos(2 * t), std::sin(2 * t), 0};
    const Vec side = unit(cross(tangent(t), knot(t) - core));
    const Vec out = cross(side, tangent(t));
    const Vec normal = std::cos(phi) * out + std::sin(phi) * side;
    return {knot(t) + kTube * normal, normal};
  };
  Mesh mesh;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.face({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)});
    }
  }
  return mesh;
}

}  // namespace spanline::make
