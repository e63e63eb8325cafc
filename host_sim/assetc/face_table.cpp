#include "assetc/face_table.hpp"

#include <algorithm>

#include "assetc/input_error.hpp"

namespace spanline::host {
namespace {

// Where the ring lengths stand in tables.contours; a repetition of the last ones is shared.
std::uint16_t add_rings(MeshTables& tables, const std::vector<std::uint16_t>& rings, const std::string& place) {
  if (rings.empty()) return 0;
  std::vector<std::uint16_t>& all = tables.contours;
  const auto count = std::ssize(rings);
  const bool repeats = std::ssize(all) >= count && std::equal(all.end() - count, all.end(), rings.begin());
  if (!repeats) all.insert(all.end(), rings.begin(), rings.end());
  if (all.size() > 65535) throw InputError(place, "has more than 65535 rings");
  return static_cast<std::uint16_t>(all.size() - rings.size());
}

}  // namespace

void append_face(MeshTables& tables, const TableFace& face, const std::string& place) {
  const auto corner_count = static_cast<std::uint16_t>(face.corner_count);
  const std::size_t rings = face.patch ? FaceGroup::kPatches : face.rings.empty() ? 1 : face.rings.size();
  const auto ring_count = static_cast<std::uint16_t>(rings | (face.curved ? FaceGroup::kCurved : 0));
  const std::uint16_t first_ring = add_rings(tables, face.rings, place);
  const auto continues = [&](const FaceGroup& group) {
    return face.first_corner == group.first_corner + std::uint32_t{group.face_count} * group.corners_per_face &&
           group.corners_per_face == corner_count && group.contour_count == ring_count &&
           group.first_contour == first_ring && group.material == face.material;
  };
  if (tables.groups.empty() || !continues(tables.groups.back())) {
    tables.groups.push_back(
        {face.first_corner, tables.face_count, 0, corner_count, first_ring, ring_count, face.material});
  }
  ++tables.groups.back().face_count;
  ++tables.face_count;
}

}  // namespace spanline::host
