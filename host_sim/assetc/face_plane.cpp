#include "assetc/face_plane.hpp"

#include <algorithm>
#include <cmath>

#include "assetc/polygon.hpp"

namespace spanline::host {
namespace {

std::int16_t to_grid(double value) { return static_cast<std::int16_t>(std::lround(value)); }

// The square of side 2 * margin moved along an edge: what is no further from it than the margin, in x and in y.
GridRing swept_square(area::GridPoint a, area::GridPoint b, std::int32_t margin) {
  if (b.x < a.x) std::swap(a, b);
  const auto at = [](std::int32_t x, std::int32_t y) {
    return area::GridPoint{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
  };
  const std::int32_t m = margin;
  if (b.y >= a.y) {
    return {at(a.x - m, a.y - m), at(a.x - m, a.y + m), at(b.x - m, b.y + m),
            at(b.x + m, b.y + m), at(b.x + m, b.y - m), at(a.x + m, a.y - m)};
  }
  return {at(a.x - m, a.y - m), at(a.x - m, a.y + m), at(a.x + m, a.y + m),
          at(b.x + m, b.y + m), at(b.x + m, b.y - m), at(b.x - m, b.y - m)};
}

// Whether `found` is true of an edge.
template <typename Found>
bool any_edge(const Region& region, Found found) {
  for (const GridRing& ring : region) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (found(ring[i], ring[(i + 1) % ring.size()])) return true;
    }
  }
  return false;
}

// Whether a point lies no further than `reach` from an edge.
bool is_near(area::GridPoint from, area::GridPoint to, area::GridPoint p, std::int32_t reach) {
  const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
  const double share = square > 0 ? std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(from.x + share * dx - p.x, from.y + share * dy - p.y) <= reach;
}

}  // namespace

std::vector<Ring3> rings_of(const MeshSource& mesh, const MeshFace& face) {
  std::vector<Ring3> rings;
  std::uint32_t next = face.first_corner;
  for (std::uint32_t ring = 0; ring < face.ring_count; ++ring) {
    const std::uint32_t count = face.ring_count > 1 ? mesh.rings[face.first_ring + ring] : face.corner_count;
    Ring3& points = rings.emplace_back();
    for (const std::uint32_t end = next + count; next < end; ++next) {
      points.push_back(mesh.positions[static_cast<std::size_t>(mesh.corners[next].position)]);
    }
  }
  return rings;
}

std::optional<FacePlane> FacePlane::of(const MeshSource& mesh, const MeshFace& face) {
  const Vec3 normal = unit_or(newell_normal(mesh, face), {});
  if (largest(normal) == 0) return std::nullopt;
  const std::vector<Ring3> rings = rings_of(mesh, face);
  const Ring3& outline = rings[0];
  Vec3 longest;  // the grid lies along the longest edge: a rectangle's corners are then all on it
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 edge = outline[(i + 1) % outline.size()] - outline[i];
    if (dot(edge, edge) > dot(longest, longest)) longest = edge;
  }
  const Vec3 right = unit_or(longest - dot(longest, normal) * normal, {}), up = cross(normal, right);
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  for (const Ring3& ring : rings) {
    for (const Vec3& p : ring) {
      const double x = dot(right, p - outline[0]), y = dot(up, p - outline[0]);
      low_x = std::min(low_x, x);
      high_x = std::max(high_x, x);
      low_y = std::min(low_y, y);
      high_y = std::max(high_y, y);
    }
  }
  const double unit = std::max(high_x - low_x, high_y - low_y) / (2.0 * kReach);
  if (!(unit > 0)) return std::nullopt;
  FacePlane plane;
  plane.origin_ = outline[0] + (low_x + high_x) / 2 * right + (low_y + high_y) / 2 * up;
  plane.right_ = unit * right;
  plane.up_ = unit * up;
  return plane;
}

area::GridPoint FacePlane::grid_point(Vec3 p) const {
  const Vec3 d = p - origin_;
  const double square = dot(right_, right_);
  const auto held = [](double v) { return std::clamp(v, double{-kReach - kMargin}, double{kReach + kMargin}); };
  return {to_grid(held(dot(right_, d) / square)), to_grid(held(dot(up_, d) / square))};
}

Region FacePlane::region(const std::vector<Ring3>& rings) const {
  Region region;
  for (const Ring3& ring : rings) {
    GridRing& points = region.emplace_back();
    for (const Vec3& p : ring) points.push_back(grid_point(p));
  }
  return region;
}

Region FacePlane::margin_along(const Region& region, const Region& face, std::int32_t margin, RegionClipper& clipper) {
  const std::int32_t reach = std::min(margin, kMargin / 8);
  const auto along = [&](area::GridPoint a, area::GridPoint b) {
    return any_edge(face, [&](area::GridPoint from, area::GridPoint to) {
      return is_near(from, to, a, reach) && is_near(from, to, b, reach);
    });
  };
  Region wide;
  any_edge(region, [&](area::GridPoint a, area::GridPoint b) {
    if (along(a, b)) wide = clipper.unite(wide, {swept_square(a, b, margin)});
    return false;
  });
  return wide;
}

}  // namespace spanline::host
