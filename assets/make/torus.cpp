#include "shapes.hpp"

namespace spanline::make {

Mesh torus(int along, int around) {
  constexpr double kTube = 0.42;
  const auto corner = [&](int i, int j) -> Mesh::Corner {
    const double t = 2 * kPi * (i % along) / along;
    const double phi = 2 * kPi * (j % around) / around;
    const Vec out = {std::cos(t), 0, -std::sin(t)};
    const Vec normal = std::cos(phi) * out + std::sin(phi) * Vec{0, 1, 0};
    return {out + kTube * normal, normal};
  };
  Mesh mesh;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.face({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      mesh.face({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace spanline::make
