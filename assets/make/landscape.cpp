#include <algorithm>
#include <cstdint>

#include "shapes.hpp"

namespace spanline::make {

namespace {

constexpr double kLake = 0;

// A repeatable scatter in -1 … 1 for grid point (i, j).
double scatter(int i, int j, std::uint32_t salt) {
  std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9E3779B1u ^ static_cast<std::uint32_t>(j) * 0x85EBCA77u ^ salt;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return (h >> 16) / 32767.5 - 1;
}

double peak(double x, double z, double at_x, double at_z, double height, double width) {
  const double dx = x - at_x;
  const double dz = z - at_z;
  return height * std::exp(-(dx * dx + dz * dz) / (width * width));
}

double height_at(double x, double z) {
  const double ranges = peak(x, z, -1.1, -1.25, 1.25, 0.62) + peak(x, z, 0.1, -1.5, 0.95, 0.55) +
                        peak(x, z, 1.3, -1.2, 1.1, 0.6) + peak(x, z, -1.6, 0.3, 0.55, 0.6) +
                        peak(x, z, 1.5, 0.2, 0.35, 0.55);
  const double basin = peak(x, z, 0.1, 0.35, -0.32, 0.75) + peak(x, z, 0.5, 1.4, -0.25, 0.6);
  return 0.1 + ranges + basin;
}

const char* cover(double low, double high, double slope) {
  if (high <= kLake) return "water";
  const double middle = (low + high) / 2;
  if (middle < 0.07) return "sand";
  if (middle > 0.8) return "snow";
  if (middle > 0.5 || slope < 0.55) return "rock";
  return middle > 0.24 ? "forest" : "grass";
}

void ground(Mesh& mesh, const Vec& a, const Vec& b, const Vec& c) {
  const double slope = unit(cross(b - a, c - a)).y;
  const auto [low, high] = std::minmax({a.y, b.y, c.y});
  mesh.material(cover(low, high, slope));
  mesh.flat({a, b, c});
}

}  // namespace

Mesh landscape(int cells) {
  constexpr double kHalfWidth = 2;
  const double step = 2 * kHalfWidth / cells;
  const auto at = [&](int i, int j) -> Vec {
    const bool border = i == 0 || j == 0 || i == cells || j == cells;
    const double jitter = border ? 0 : 0.3 * step;
    const double x = -kHalfWidth + i * step + jitter * scatter(i, j, 1);
    const double z = -kHalfWidth + j * step + jitter * scatter(i, j, 2);
    const double height = height_at(x, z);
    return {x, std::max(kLake, height * (1 + 0.12 * scatter(i, j, 3))), z};
  };
  Mesh mesh;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const Vec a = at(i, j);
      const Vec b = at(i, j + 1);
      const Vec c = at(i + 1, j + 1);
      const Vec d = at(i + 1, j);
      // Diagonals alternate, else the hills show a grain.
      if ((i + j) % 2 == 0) {
        ground(mesh, a, b, c);
        ground(mesh, a, c, d);
      } else {
        ground(mesh, a, b, d);
        ground(mesh, b, c, d);
      }
    }
  }
  return mesh;
}

}  // namespace spanline::make
