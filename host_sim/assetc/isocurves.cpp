#include "assetc/isocurves.hpp"

#include <algorithm>

namespace spanline::host {
namespace {

Vec3 bezier_at(const BezierPoints& p, double t) {
  const double s = 1 - t;
  return (s * s * s) * p[0] + (3 * s * s * t) * p[1] + (3 * s * t * t) * p[2] + (t * t * t) * p[3];
}

// Row (or, transposed, column) by row at `t`, the control points of the curve there.
BezierPoints curve_at(const BptPatch& patch, double t, bool along_rows) {
  BezierPoints curve;
  for (std::size_t i = 0; i < 4; ++i) {
    BezierPoints line;
    for (std::size_t j = 0; j < 4; ++j) line[j] = along_rows ? patch.points[j][i] : patch.points[i][j];
    curve[i] = bezier_at(line, t);
  }
  return curve;
}

bool same(const BezierPoints& a, const BezierPoints& b) {
  return std::equal(a.begin(), a.end(), b.begin()) || std::equal(a.begin(), a.end(), b.rbegin());
}

void add(std::vector<BezierPoints>& curves, const BezierPoints& curve) {
  const bool one_point = std::all_of(curve.begin(), curve.end(), [&](Vec3 p) { return p == curve[0]; });
  const bool known = std::any_of(curves.begin(), curves.end(), [&](const BezierPoints& c) { return same(c, curve); });
  if (!one_point && !known) curves.push_back(curve);
}

}  // namespace

std::vector<BezierPoints> isocurves(const std::vector<BptPatch>& patches, int across, int down) {
  std::vector<BezierPoints> curves;
  for (const BptPatch& patch : patches) {
    for (int i = 0; i <= across; ++i) add(curves, curve_at(patch, static_cast<double>(i) / across, false));
    for (int i = 0; i <= down; ++i) add(curves, curve_at(patch, static_cast<double>(i) / down, true));
  }
  return curves;
}

}  // namespace spanline::host
