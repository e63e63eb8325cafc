#include <map>
#include <unordered_map>

#include "assetc/compile.hpp"
#include "assetc/extent.hpp"
#include "assetc/face_table.hpp"
#include "assetc/fans.hpp"
#include "assetc/fixed_point.hpp"
#include "assetc/input_error.hpp"
#include "assetc/polygon.hpp"

namespace spanline::host {
namespace {

Normal10 pack_normal(Vec3 normal) {
  const Vec3 n = 511 * unit_or(normal, {0, 0, 1});  // a face without area is never drawn: any normal serves
  return Normal10::pack(static_cast<int>(std::lround(n.x)), static_cast<int>(std::lround(n.y)),
                        static_cast<int>(std::lround(n.z)));
}

std::int16_t to_int16(double value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, double{INT16_MIN}, double{INT16_MAX})));
}

// Maps points of the mesh to 16-bit positions and sets origin and unit of the tables accordingly.
class Quantiser {
 public:
  Quantiser(const Box& box, const MeshFit& fit, MeshTables& tables) : fit_(fit) {
    put(tables.origin, fit(box.centre()));
    origin_ = {std::ldexp(tables.origin[0].raw, -16), std::ldexp(tables.origin[1].raw, -16),
               std::ldexp(tables.origin[2].raw, -16)};
    const double half = std::max(largest(fit(box.low) - origin_), largest(fit(box.high) - origin_));
    // Rounded up, and positions are taken in the rounded unit: the error of the unit itself never shows.
    tables.unit = std::max(1, round_to_int32(std::ceil(std::ldexp(half / INT16_MAX, 31))));
    per_unit_ = std::ldexp(1.0 / tables.unit, 31);
  }

  Position operator()(Vec3 p) const {
    const Vec3 q = per_unit_ * (fit_(p) - origin_);
    return {to_int16(q.x), to_int16(q.y), to_int16(q.z)};
  }

 private:
  MeshFit fit_;
  Vec3 origin_;
  double per_unit_;
};

// See InstanceRecord::kScreen.
Position screen_position(Vec3 p) { return {to_int16(p.x), to_int16(p.y), to_int16(p.z - 32768)}; }

// Numbers the vertices that faces use, in the order of first use; split by normal where that matters.
class VertexTable {
 public:
  explicit VertexTable(bool smooth) : smooth_(smooth) {}

  std::uint32_t number(ObjCorner corner) {
    if (!smooth_) corner.normal = kNone;
    const std::uint64_t key =
        static_cast<std::uint64_t>(corner.position) << 32 | static_cast<std::uint32_t>(corner.normal);
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
    if (is_new) vertices_.push_back(corner);
    return found->second;
  }
  const std::vector<ObjCorner>& vertices() const { return vertices_; }

 private:
  bool smooth_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<ObjCorner> vertices_;
};

void add_corners(const MeshSource& mesh, VertexTable& vertices, MeshTables& tables) {
  tables.corners.reserve(mesh.corners.size());
  for (const ObjCorner& corner : mesh.corners) {
    const std::uint32_t number = vertices.number(corner);
    if (number >= kMaxSceneVertices) {
      throw InputError(mesh.place, "needs more than " + std::to_string(kMaxSceneVertices) + " vertices");
    }
    tables.corners.push_back(static_cast<std::uint16_t>(number));
  }
}

void add_normals(const MeshSource& mesh, const VertexTable& vertices, bool smooth, MeshTables& tables) {
  for (const MeshFace& face : mesh.faces) tables.face_normals.push_back(pack_normal(newell_normal(mesh, face)));
  if (!smooth) return;
  const std::vector<Vec3> around = position_normals(mesh);
  for (const ObjCorner& vertex : vertices.vertices()) {
    const Vec3 own = vertex.normal == kNone ? Vec3{} : mesh.normals[static_cast<std::size_t>(vertex.normal)];
    const Vec3& mean = around[static_cast<std::size_t>(vertex.position)];
    tables.vertex_normals.push_back(pack_normal(largest(own) > 0 ? own : mean));
  }
}

void add_faces(const MeshSource& mesh, std::uint16_t default_material, MeshTables& tables) {
  for (const MeshFace& face : mesh.faces) {
    TableFace entry{face.first_corner, face.corner_count, {}, default_material, mesh.of_patches(), face.curved};
    const auto rings = mesh.rings.begin() + face.first_ring;
    if (face.ring_count > 1) entry.rings.assign(rings, rings + face.ring_count);
    if (face.material != kNone) entry.material = static_cast<std::uint16_t>(face.material);
    append_face(tables, entry, mesh.place);
  }
}

template <typename T>
Slice<const T> view_of(const std::vector<T>& items) {
  return {items.data(), static_cast<std::uint32_t>(items.size())};
}

PositionBox box_around(const std::vector<Position>& positions) {
  PositionBox box{positions.front(), positions.front()};
  for (const Position& p : positions) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

}  // namespace

MeshRecord MeshTables::record() const {
  return {name.c_str(),
          view_of(positions),
          view_of(vertex_normals),
          view_of(face_normals),
          view_of(corners),
          view_of(contours),
          view_of(groups),
          face_count,
          {origin[0], origin[1], origin[2]},
          unit,
          view_of(fan_starts),
          view_of(fans),
          view_of(curves),
          view_of(parents),
          box_around(positions)};
}

MeshTables compile_mesh(const MeshSource& mesh, const std::vector<MaterialSpec>& materials, const MeshFit& fit,
                        bool smooth, bool on_screen) {
  MeshTables tables;
  tables.name = mesh.name;
  tables.parents = mesh.parents;
  VertexTable vertices(smooth);
  add_corners(mesh, vertices, tables);
  if (on_screen) {
    for (const ObjCorner& vertex : vertices.vertices()) {
      tables.positions.push_back(screen_position(mesh.positions[static_cast<std::size_t>(vertex.position)]));
    }
  } else {
    const Quantiser quantise(used_box(mesh), fit, tables);
    for (const ObjCorner& vertex : vertices.vertices()) {
      tables.positions.push_back(quantise(mesh.positions[static_cast<std::size_t>(vertex.position)]));
    }
    if (!mesh.of_patches()) add_normals(mesh, vertices, smooth, tables);
  }
  const auto default_material = static_cast<std::uint16_t>(materials.size() - 1);
  add_faces(mesh, default_material, tables);
  if (!on_screen) build_fans(tables);
  for (const MeshCurve& curve : mesh.curves) tables.curves.push_back(curve.record(default_material));
  return tables;
}

}  // namespace spanline::host
