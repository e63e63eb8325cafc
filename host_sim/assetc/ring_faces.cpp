#include "assetc/ring_faces.hpp"

#include "assetc/face_table.hpp"

namespace spanline::host {
namespace {

std::vector<GridSegment> segments_of(const std::vector<Ring>& rings, const std::vector<Position>& positions,
                                     const Flattened& flat) {
  std::vector<GridSegment> segments;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments.push_back({flat(positions[ring[i]]), flat(positions[ring[(i + 1) % ring.size()]])});
    }
  }
  return segments;
}

// Sorted by their left ends, so that only neighbours are compared.
bool disjoint(std::vector<GridSegment> segments) {
  const auto left = [](const GridSegment& s) { return std::min(s.from.u, s.to.u); };
  const auto right = [](const GridSegment& s) { return std::max(s.from.u, s.to.u); };
  std::sort(segments.begin(), segments.end(),
            [&](const GridSegment& a, const GridSegment& b) { return left(a) < left(b); });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size() && left(segments[j]) <= right(segments[i]); ++j) {
      if (collide(segments[i], segments[j])) return false;
    }
  }
  return true;
}

}  // namespace

GridVector newell(const Ring& ring, const std::vector<Position>& positions) {
  GridVector sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    sum = sum + cross(positions[ring[i]] - positions[ring[0]], positions[ring[i + 1]] - positions[ring[0]]);
  }
  return sum;
}

bool are_simple(const std::vector<Ring>& rings, const std::vector<Position>& positions, GridVector normal) {
  return disjoint(segments_of(rings, positions, Flattened(normal)));
}

std::vector<RingFace> ring_faces(const MeshTables& mesh) {
  std::vector<RingFace> faces;
  for (const FaceGroup& group : mesh.groups) {
    for (std::uint32_t i = 0; i < group.face_count; ++i) {
      auto corner = mesh.corners.begin() + group.first_corner + std::ptrdiff_t{group.corners_per_face} * i;
      RingFace face;
      for (std::uint32_t ring = 0; ring < group.rings(); ++ring) {
        const std::uint16_t count =
            group.rings() == 1 ? group.corners_per_face : mesh.contours[group.first_contour + ring];
        face.rings.emplace_back(corner, corner + count);
        corner += count;
      }
      face.material = group.material;
      face.curved = group.curved();
      face.normal = newell(face.rings.front(), mesh.positions);
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

void append_rings(MeshTables& out, const std::vector<Ring>& rings, std::uint16_t material, bool curved,
                  const std::string& place) {
  TableFace face{static_cast<std::uint32_t>(out.corners.size()), 0, {}, material, false, curved};
  for (const Ring& ring : rings) {
    if (rings.size() > 1) face.rings.push_back(static_cast<std::uint16_t>(ring.size()));
    out.corners.insert(out.corners.end(), ring.begin(), ring.end());
  }
  face.corner_count = static_cast<std::uint32_t>(out.corners.size()) - face.first_corner;
  append_face(out, face, place);
}

}  // namespace spanline::host
