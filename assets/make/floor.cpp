#include "shapes.hpp"

namespace spanline::make {

Mesh checkered_floor(int squares) {
  Mesh mesh;
  for (int color = 0; color < 2; ++color) {
    mesh.material(color == 0 ? "light" : "dark");
    for (int i = 0; i < squares; ++i) {
      for (int j = 0; j < squares; ++j) {
        if ((i + j) % 2 != color) continue;
        const auto at = [&](int k) { return -1 + 2.0 * k / squares; };
        mesh.flat({{at(i), 0, at(j)}, {at(i), 0, at(j + 1)}, {at(i + 1), 0, at(j + 1)}, {at(i + 1), 0, at(j)}});
      }
    }
  }
  return mesh;
}

}  // namespace spanline::make
