#include "assetc/face_plane.hpp"

#include "assetc/polygon.hpp"

namespace spanline::host {
namespace {

// A point thrown onto the plane: where, and how far the light has to go from it to the plane.
struct Thrown {
  double x, y, way;
};

// Keeps what of a ring lies where distance(p) >= 0; what runs along the border cancels itself out.
template <typename Distance>
void keep_half(std::vector<Thrown>& ring, Distance distance) {
  std::vector<Thrown> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Thrown& a = ring[i];
    const Thrown& b = ring[(i + 1) % ring.size()];
    const double da = distance(a), db = distance(b);
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0)) {
      const double t = da / (da - db);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.way + t * (b.way - a.way)});
    }
  }
  ring = std::move(kept);
}

std::int16_t to_grid(double value) { return static_cast<std::int16_t>(std::lround(value)); }

bool beyond(const std::vector<Thrown>& ring, double edge) {
  const auto all = [&ring](auto test) { return std::all_of(ring.begin(), ring.end(), test); };
  return all([=](const Thrown& p) { return p.x < -edge; }) || all([=](const Thrown& p) { return p.x > edge; }) ||
         all([=](const Thrown& p) { return p.y < -edge; }) || all([=](const Thrown& p) { return p.y > edge; });
}

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
  const auto held = [](double v) { return std::clamp(v, double{-kWindow}, double{kWindow}); };
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

Region FacePlane::with_margin(const Region& region, RegionClipper& clipper) const {
  Region wide = region;
  for (const GridRing& ring : region) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      wide = clipper.unite(wide, {swept_square(ring[i], ring[(i + 1) % ring.size()], kMargin)});
    }
  }
  return wide;
}

std::optional<ShadowThrow> ShadowThrow::onto(const FacePlane& plane, const Placement& place, Vec3 direction) {
  constexpr double kGrazing = 1e-4;  // sine of the angle between light and plane: nothing is lit by such a light
  constexpr double kInPlane = 0.5;   // grid units
  const Vec3 right = place.turn(plane.right()), up = place.turn(plane.up());
  const Vec3 normal = cross(right, up);
  const double volume = -dot(normal, direction);  // of right, up and the way against the light
  if (!(std::fabs(volume) > kGrazing * length(normal))) return std::nullopt;
  ShadowThrow out;
  out.origin_ = place(plane.origin());
  // p = x * right + y * up - way * direction, by Cramer's rule.
  const Vec3 back = -1.0 * direction;
  out.to_x_ = (1 / volume) * cross(up, back);
  out.to_y_ = (1 / volume) * cross(back, right);
  out.to_way_ = (1 / volume) * normal;
  out.nearest_ = kInPlane * std::min(length(right), length(up)) * length(normal) / std::fabs(volume);
  return out;
}

Region ShadowThrow::shadow(const std::vector<Ring3>& rings) const {
  Region region;
  for (const Ring3& ring : rings) {
    std::vector<Thrown> thrown;
    for (const Vec3& p : ring) {
      const Vec3 d = p - origin_;
      thrown.push_back({dot(to_x_, d), dot(to_y_, d), dot(to_way_, d)});
    }
    constexpr double kEdge = FacePlane::kWindow;
    keep_half(thrown, [this](const Thrown& p) { return p.way - nearest_; });
    if (thrown.size() < 3 || beyond(thrown, kEdge)) continue;
    keep_half(thrown, [](const Thrown& p) { return p.x + kEdge; });
    keep_half(thrown, [](const Thrown& p) { return kEdge - p.x; });
    keep_half(thrown, [](const Thrown& p) { return p.y + kEdge; });
    keep_half(thrown, [](const Thrown& p) { return kEdge - p.y; });
    GridRing& points = region.emplace_back();
    for (const Thrown& p : thrown) points.push_back({to_grid(p.x), to_grid(p.y)});
  }
  return region;
}

}  // namespace spanline::host
