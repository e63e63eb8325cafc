#include "curve/screen_net.hpp"

#include <algorithm>
#include <cmath>

namespace spanline::test {
namespace {

using Weights = std::array<double, 4>;

Weights weights(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
Weights slopes(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
}

At sum(const ScreenNet& net, const Weights& u, const Weights& v) {
  At at{0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      at.x += u[j] * v[i] * net.control[i][j].x;
      at.y += u[j] * v[i] * net.control[i][j].y;
    }
  }
  return at;
}

// A corner of a triangle of the patch.
struct Corner {
  At at;
  ScreenNet::Root place;
};

double doubled_area(At a, At b, At c) { return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y); }

void cover(const Corner& a, const Corner& b, const Corner& c, std::array<ScreenNet::Sheet, 2>& sheets) {
  const double area = doubled_area(a.at, b.at, c.at);
  if (area == 0) return;
  const auto first = [](double low) { return static_cast<int>(std::ceil(low - 0.5)); };
  const auto [left, right] = std::minmax({a.at.x, b.at.x, c.at.x});
  const auto [top, bottom] = std::minmax({a.at.y, b.at.y, c.at.y});
  for (int y = first(top); y + 0.5 <= bottom; ++y) {
    for (int x = first(left); x + 0.5 <= right; ++x) {
      const At centre{x + 0.5, y + 0.5};
      const double of_b = doubled_area(a.at, centre, c.at) / area, of_c = doubled_area(a.at, b.at, centre) / area;
      if (of_b < 0 || of_c < 0 || of_b + of_c > 1) continue;
      const auto mix = [&](double p, double q, double r) { return p + of_b * (q - p) + of_c * (r - p); };
      sheets[area > 0].insert({{y, x}, {mix(a.place.u, b.place.u, c.place.u), mix(a.place.v, b.place.v, c.place.v)}});
    }
  }
}

}  // namespace

ScreenNet::ScreenNet(const PatchView& view, const PatchPoints& points) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const ClipPoint p = view.matrix(points[i][j]);
      control[i][j] = {160 + 1024.0 * p.x / p.w, 120 + 1024.0 * p.y / p.w};
    }
  }
}

At ScreenNet::at(double u, double v) const { return sum(*this, weights(u), weights(v)); }

ScreenNet::Derivatives ScreenNet::derivatives(double u, double v) const {
  return {sum(*this, slopes(u), weights(v)), sum(*this, weights(u), slopes(v))};
}

std::array<Cubic, 4> ScreenNet::sides() const {
  std::array<Cubic, 4> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    const At points[4] = {control[0][k], control[3][k], control[k][0], control[k][3]};
    for (std::size_t side = 0; side < 4; ++side) {
      sides[side].p[k] = {static_cast<std::int32_t>(std::lround(16 * points[side].x)),
                          static_cast<std::int32_t>(std::lround(16 * points[side].y))};
    }
  }
  return sides;
}

std::array<ScreenNet::Sheet, 2> ScreenNet::sheets() const {
  constexpr int kFine = 32;
  const auto corner = [this](int i, int j) {
    const Root place{static_cast<double>(j) / kFine, static_cast<double>(i) / kFine};
    return Corner{at(place.u, place.v), place};
  };
  std::array<Sheet, 2> sheets;
  for (int i = 0; i < kFine; ++i) {
    for (int j = 0; j < kFine; ++j) {
      cover(corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), sheets);
      cover(corner(i, j), corner(i + 1, j + 1), corner(i + 1, j), sheets);
    }
  }
  return sheets;
}

}  // namespace spanline::test
