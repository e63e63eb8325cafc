#include "assetc/polygon.hpp"

namespace spanline::host {

Vec3 newell_normal(const MeshSource& mesh, const MeshFace& face) {
  const std::uint32_t count = face.ring_count > 1 ? mesh.rings[face.first_ring] : face.corner_count;
  const auto at = [&](std::uint32_t i) {
    return mesh.positions[static_cast<std::size_t>(mesh.corners[face.first_corner + i].position)];
  };
  const Vec3 origin = at(0);  // differences first: a small face far from the origin keeps its digits
  Vec3 sum;
  for (std::uint32_t i = 1; i + 1 < count; ++i) sum = sum + cross(at(i) - origin, at(i + 1) - origin);
  return sum;
}

std::vector<Vec3> position_normals(const MeshSource& mesh) {
  std::vector<Vec3> sums(mesh.positions.size());
  const auto add = [&](const MeshFace& face, std::vector<Vec3>& to) {
    const Vec3 normal = newell_normal(mesh, face);
    for (std::uint32_t i = 0; i < face.corner_count; ++i) {
      Vec3& sum = to[static_cast<std::size_t>(mesh.corners[face.first_corner + i].position)];
      sum = sum + normal;
    }
  };
  const std::size_t first_detail = mesh.faces.size() - mesh.parents.size();
  for (std::size_t i = 0; i < first_detail; ++i) add(mesh.faces[i], sums);
  if (mesh.parents.empty()) return sums;
  std::vector<Vec3> of_detail(mesh.positions.size());
  for (std::size_t i = first_detail; i < mesh.faces.size(); ++i) add(mesh.faces[i], of_detail);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (largest(sums[i]) == 0) sums[i] = of_detail[i];
  }
  return sums;
}

}  // namespace spanline::host
