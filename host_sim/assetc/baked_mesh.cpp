#include "assetc/baked_mesh.hpp"

#include "assetc/detail.hpp"
#include "assetc/polygon.hpp"

namespace spanline::host {
namespace {

ReachRecord all_light() {
  ReachRecord reach;
  for (Rgb8& light : reach.light) light = {255, 255, 255};
  return reach;
}

}  // namespace

BakedMesh::BakedMesh(const MeshSource& source, RegionClipper& clipper)
    : source_(source), clipper_(clipper), around_(position_normals(source)), out_(source) {
  out_.faces.clear();
  out_.parents.clear();
}

std::vector<std::size_t> BakedMesh::detail_on(std::size_t face) const {
  std::vector<std::size_t> all;
  const std::size_t first = source_.faces.size() - source_.parents.size();
  for (std::size_t i = 0; i < source_.parents.size(); ++i) {
    if (source_.parents[i] == face) all.push_back(first + i);
  }
  return all;
}

void BakedMesh::keep(std::size_t face, const Naming& name) { keep_with(face, all_light(), name); }

void BakedMesh::keep_with(std::size_t face, const ReachRecord& reach, const Naming& name) {
  const MeshFace& source = source_.faces[face];
  out_.faces.push_back(source);
  out_.faces.back().material = name(source, reach);
  for (const std::size_t detail : detail_on(face)) {
    keep_detail(face, source_.faces[detail], name(source_.faces[detail], reach));
  }
}

void BakedMesh::keep_detail(std::size_t parent, const MeshFace& detail, std::int32_t material) {
  detail_.push_back(detail);
  detail_.back().material = material;
  out_.parents.push_back(static_cast<std::uint16_t>(parent));
}

void BakedMesh::add(std::size_t face, const FacePlane& plane, const std::vector<ShadowPart>& parts,
                    const Naming& name) {
  if (parts.empty()) return keep(face, name);
  const MeshFace& source = source_.faces[face];
  const ReachRecord lit = all_light();
  const bool reached = std::equal(lit.light, lit.light + kMaxLights, parts[0].reach.light);
  changed_ = changed_ || parts.size() > 1 || !reached;
  if (parts.size() == 1) return keep_with(face, parts[0].reach, name);
  Corners corners{plane, source, {}};
  remember(source, corners);
  out_.faces.push_back(source);
  out_.faces.back().material = name(source, parts[0].reach);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    add_detail(face, parts[i].region, name(source, parts[i].reach), corners);
  }
  for (const std::size_t index : detail_on(face)) {
    const MeshFace& detail = source_.faces[index];
    remember(detail, corners);
    const Region region = plane.region(rings_of(source_, detail));
    for (const ShadowPart& part : parts) {
      add_detail(face, clipper_.split(region, part.region).inside, name(detail, part.reach), corners);
    }
  }
}

void BakedMesh::remember(const MeshFace& face, Corners& corners) const {
  for (std::uint32_t i = 0; i < face.corner_count; ++i) {
    const ObjCorner corner = source_.corners[face.first_corner + i];
    const area::GridPoint at = corners.plane.grid_point(source_.positions[static_cast<std::size_t>(corner.position)]);
    corners.known.try_emplace({at.x, at.y}, corner);
  }
}

void BakedMesh::add_detail(std::size_t parent, const Region& region, std::int32_t material, Corners& corners) {
  if (region.empty()) return;
  for (const GridPolygon& polygon : clipper_.polygons(region)) {
    MeshFace face{static_cast<std::uint32_t>(out_.corners.size()), 0, static_cast<std::uint32_t>(out_.rings.size()),
                  static_cast<std::uint32_t>(polygon.size()), material};
    for (const GridRing& ring : polygon) {
      for (const area::GridPoint& point : ring) out_.corners.push_back(corner_at(point, corners));
      if (polygon.size() > 1) out_.rings.push_back(static_cast<std::uint16_t>(ring.size()));
    }
    face.corner_count = static_cast<std::uint32_t>(out_.corners.size()) - face.first_corner;
    keep_detail(parent, face, material);
  }
}

ObjCorner BakedMesh::corner_at(area::GridPoint point, Corners& corners) {
  const auto [found, is_new] = corners.known.try_emplace({point.x, point.y});
  if (is_new) {
    found->second = {static_cast<std::int32_t>(out_.positions.size()), normal_at(point, corners)};
    out_.positions.push_back(corners.plane.at(point));
  }
  return found->second;
}

// What Gouraud shading makes of the normals at the face's corners: linear in the triangle of a fan that the point lies
// in, or is least far out of.
std::int32_t BakedMesh::normal_at(area::GridPoint point, const Corners& corners) {
  const auto grid = [&](std::uint32_t i) {
    const ObjCorner corner = source_.corners[corners.face.first_corner + i];
    return corners.plane.grid_point(source_.positions[static_cast<std::size_t>(corner.position)]);
  };
  const auto normal = [&](std::uint32_t i) {
    const ObjCorner corner = source_.corners[corners.face.first_corner + i];
    const Vec3 own = corner.normal == kNone ? Vec3{} : source_.normals[static_cast<std::size_t>(corner.normal)];
    return unit_or(largest(own) > 0 ? own : around_[static_cast<std::size_t>(corner.position)], {});
  };
  double best = -1e300;
  Vec3 sum = normal(0);
  for (std::uint32_t i = 1; i + 1 < corners.face.corner_count; ++i) {
    const area::GridPoint a = grid(0), b = grid(i), c = grid(i + 1);
    const auto whole = static_cast<double>(area::orientation(a, b, c));
    if (whole == 0) continue;
    const double at_a = static_cast<double>(area::orientation(point, b, c)) / whole;
    const double at_b = static_cast<double>(area::orientation(a, point, c)) / whole;
    const double least = std::min({at_a, at_b, 1 - at_a - at_b});
    if (least <= best) continue;
    best = least;
    sum = at_a * normal(0) + at_b * normal(i) + (1 - at_a - at_b) * normal(i + 1);
  }
  out_.normals.push_back(sum);
  return static_cast<std::int32_t>(out_.normals.size()) - 1;
}

MeshSource BakedMesh::take() {
  out_.faces.insert(out_.faces.end(), detail_.begin(), detail_.end());
  turn_detail(out_);
  return std::move(out_);
}

}  // namespace spanline::host
