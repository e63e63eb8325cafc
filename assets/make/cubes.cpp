#include "shapes.hpp"

namespace spanline::make {

namespace {

// Turned about (1, 1, 1), which keeps all three cubes equally pierced.
Vec turned(Vec v, double angle) {
  const Vec axis = unit({1, 1, 1});
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + ((1 - std::cos(angle)) * dot(axis, v)) * axis;
}

}  // namespace

Mesh penetrating_cubes() {
  Mesh mesh;
  for (int cube = 0; cube < 3; ++cube) {
    mesh.material("cube" + std::to_string(cube + 1));
    const double angle = cube * 2 * kPi / 9;
    for (int side = 0; side < 6; ++side) {
      const double sign = side < 3 ? 1 : -1;
      const auto corner = [&](double a, double b) {
        const std::array<double, 3> along = {sign, a, sign * b};
        const auto at = [&](int axis) { return along[static_cast<std::size_t>((axis - side % 3 + 3) % 3)]; };
        return turned({at(0), at(1), at(2)}, angle);
      };
      mesh.flat({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
    }
  }
  return mesh;
}

}  // namespace spanline::make
