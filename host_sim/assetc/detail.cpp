#include "assetc/detail.hpp"

#include <algorithm>

#include "assetc/input_error.hpp"
#include "assetc/polygon.hpp"

namespace spanline::host {
namespace {

Vec3 corner(const MeshSource& mesh, const MeshFace& face, std::uint32_t i) {
  return mesh.positions[static_cast<std::size_t>(mesh.corners[face.first_corner + i].position)];
}

std::uint32_t ring_length(const MeshSource& mesh, const MeshFace& face, std::uint32_t ring) {
  return face.ring_count > 1 ? mesh.rings[face.first_ring + ring] : face.corner_count;
}

Vec3 middle(const MeshSource& mesh, const MeshFace& face) {
  Vec3 sum;
  for (std::uint32_t i = 0; i < face.corner_count; ++i) sum = sum + corner(mesh, face, i);
  return (1.0 / face.corner_count) * sum;
}

// Even-odd, seen along the axis that the normal is closest to.
bool covers(const MeshSource& mesh, const MeshFace& face, Vec3 normal, Vec3 point) {
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  const auto flat = [&](Vec3 p) {
    if (x >= y && x >= z) return std::pair(p.y, p.z);
    return y >= z ? std::pair(p.z, p.x) : std::pair(p.x, p.y);
  };
  const auto [u, v] = flat(point);
  bool inside = false;
  std::uint32_t first = 0;
  for (std::uint32_t ring = 0; ring < face.ring_count; ++ring) {
    const std::uint32_t count = ring_length(mesh, face, ring);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto [ua, va] = flat(corner(mesh, face, first + i));
      const auto [ub, vb] = flat(corner(mesh, face, first + (i + 1) % count));
      if ((va > v) != (vb > v) && u < ua + (ub - ua) * (v - va) / (vb - va)) inside = !inside;
    }
    first += count;
  }
  return inside;
}

std::string number_of(const MeshSource& mesh, const MeshFace& face) {
  return std::to_string(&face - mesh.faces.data() + 1);
}

std::uint16_t parent_of(const MeshSource& mesh, const MeshFace& detail, const std::vector<MeshFace>& candidates) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Vec3 normal = newell_normal(mesh, candidates[i]);
    if (largest(normal) > 0 && lies_on(mesh, candidates[i], detail) &&
        covers(mesh, candidates[i], normal, middle(mesh, detail))) {
      return static_cast<std::uint16_t>(i);
    }
  }
  throw InputError(mesh.place,
                   "face " + number_of(mesh, detail) + " is to be surface detail and lies on no other face");
}

}  // namespace

bool lies_on(const MeshSource& mesh, const MeshFace& parent, const MeshFace& detail) {
  constexpr double kSlack = 1e-3;
  const Vec3 origin = corner(mesh, parent, 0), normal = unit_or(newell_normal(mesh, parent), {});
  double size = 0;
  for (std::uint32_t i = 1; i < parent.corner_count; ++i) {
    size = std::max(size, largest(corner(mesh, parent, i) - origin));
  }
  for (std::uint32_t i = 0; i < detail.corner_count; ++i) {
    if (std::fabs(dot(normal, corner(mesh, detail, i) - origin)) > kSlack * size) return false;
  }
  return true;
}

void turn_detail(MeshSource& mesh) {
  const std::size_t first = mesh.faces.size() - mesh.parents.size();
  for (std::size_t i = 0; i < mesh.parents.size(); ++i) {
    const MeshFace& face = mesh.faces[first + i];
    if (dot(newell_normal(mesh, face), newell_normal(mesh, mesh.faces[mesh.parents[i]])) >= 0) continue;
    auto begin = mesh.corners.begin() + face.first_corner;
    for (std::uint32_t ring = 0; ring < face.ring_count; ++ring) {
      const auto end = begin + ring_length(mesh, face, ring);
      std::reverse(begin, end);
      begin = end;
    }
  }
}

void set_detail(MeshSource& mesh, const std::vector<MaterialSpec>& materials, const std::vector<std::string>& names) {
  const auto name_of = [&](const MeshFace& face) {
    return face.material == kNone ? std::string() : materials[static_cast<std::size_t>(face.material)].name;
  };
  std::vector<MeshFace> kept, detail;
  for (const MeshFace& face : mesh.faces) {
    (std::find(names.begin(), names.end(), name_of(face)) == names.end() ? kept : detail).push_back(face);
  }
  for (const std::string& name : names) {
    if (std::none_of(detail.begin(), detail.end(), [&](const MeshFace& face) { return name_of(face) == name; })) {
      throw InputError(mesh.place, "no face has the material '" + printable(name) + "'");
    }
  }
  for (const MeshFace& face : mesh.faces) {
    if (std::find(names.begin(), names.end(), name_of(face)) == names.end()) continue;
    mesh.parents.push_back(parent_of(mesh, face, kept));
  }
  kept.insert(kept.end(), detail.begin(), detail.end());
  mesh.faces = std::move(kept);
  turn_detail(mesh);
}

void check_detail(const MeshSource& mesh, const std::vector<MaterialSpec>& materials) {
  const auto is_opaque = [&](const MeshFace& face) {
    const MaterialSpec& material =
        face.material == kNone ? materials.back() : materials[static_cast<std::size_t>(face.material)];
    return material.transmission == Color{};
  };
  const std::size_t first = mesh.faces.size() - mesh.parents.size();
  for (std::size_t i = 0; i < mesh.parents.size(); ++i) {
    if (is_opaque(mesh.faces[mesh.parents[i]]) && !is_opaque(mesh.faces[first + i])) {
      throw InputError(mesh.place,
                       "see-through surface detail lies on the opaque face " + std::to_string(mesh.parents[i]));
    }
  }
}

}  // namespace spanline::host
