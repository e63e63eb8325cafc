#include <algorithm>

#include "assetc/bpt.hpp"
#include "shapes.hpp"

namespace spanline::make {

namespace {

using Patch = std::array<std::array<Vec, 4>, 4>;

// z up becomes y up.
Patch upright(const host::BptPatch& z_up) {
  Patch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const host::Vec3 p = z_up.points[i][j];
      patch[i][j] = {p.x, p.z, -p.y};
    }
  }
  return patch;
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

std::array<double, 4> bernstein_slope(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Vec blend(const Patch& patch, const std::array<double, 4>& u, const std::array<double, 4>& v) {
  Vec sum;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) sum = sum + (u[i] * v[j]) * patch[i][j];
  }
  return sum;
}

Vec cross_of_tangents(const Patch& patch, double u, double v) {
  return cross(blend(patch, bernstein(u), bernstein_slope(v)), blend(patch, bernstein_slope(u), bernstein(v)));
}

// The published data winds the four patches under the foot the other way round; turned over they agree with the rest.
void turn_bottom(Patch& patch) {
  constexpr double kFoot = 0.151;
  double top = 0;
  for (const auto& row : patch) {
    for (const Vec& point : row) top = std::max(top, point.y);
  }
  if (top < kFoot) std::reverse(patch.begin(), patch.end());
}

// At a pole one tangent vanishes; a hair inside the patch the normal is the pole's.
Vec normal_at(const Patch& patch, double u, double v) {
  constexpr double kHair = 1e-5;
  const Vec here = cross_of_tangents(patch, u, v);
  if (length(here) > 1e-9) return unit(here);
  return unit(cross_of_tangents(patch, std::fabs(u - kHair), std::fabs(v - kHair)));
}

}  // namespace

Mesh dice_patches(const std::string& bpt, int steps, bool triangles) {
  Mesh mesh;
  for (const host::BptPatch& z_up : host::read_bpt(bpt)) {
    Patch patch = upright(z_up);
    turn_bottom(patch);
    const auto corner = [&](int i, int j) -> Mesh::Corner {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      return {blend(patch, bernstein(u), bernstein(v)), normal_at(patch, u, v)};
    };
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; j < steps; ++j) {
        const auto a = corner(i, j);
        const auto b = corner(i + 1, j);
        const auto c = corner(i + 1, j + 1);
        const auto d = corner(i, j + 1);
        if (triangles) {
          mesh.face({a, c, b});
          mesh.face({a, d, c});
        } else {
          mesh.face({a, d, c, b});
        }
      }
    }
  }
  return mesh;
}

}  // namespace spanline::make
