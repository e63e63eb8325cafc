#include "assetc/scene_description.hpp"

#include <map>
#include <utility>

namespace spanline::host {
namespace {

// A turn by `degrees` about a unit axis (Rodrigues): p cos + (a x p) sin + a (a . p) (1 - cos).
Placement turn_about(Vec3 axis, double degrees) {
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  const auto turned = [&](Vec3 p) { return c * p + s * cross(axis, p) + ((1 - c) * dot(axis, p)) * axis; };
  const Vec3 x = turned({1, 0, 0}), y = turned({0, 1, 0}), z = turned({0, 0, 1});
  return {{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}}, {}};
}

bool all_corners_have_normals(const ObjMesh& obj, const ObjFace& face) {
  for (std::uint32_t i = 0; i < face.corner_count; ++i) {
    if (obj.corners[face.first_corner + i].normal == kNone) return false;
  }
  return true;
}

Shading shading_of(const ObjMesh& obj, const ObjFace& face, MeshShading wanted) {
  switch (wanted) {
    case MeshShading::flat:
      return Shading::kFlat;
    case MeshShading::gouraud:
      return Shading::kGouraud;
    case MeshShading::unlit:
      return Shading::kUnlit;
    default:
      return all_corners_have_normals(obj, face) ? Shading::kGouraud : Shading::kFlat;
  }
}

}  // namespace

Placement InstanceSpec::placement(std::int64_t frame) const {
  if (matrix) return *matrix;
  const Pose p = motion.at(frame, pose);
  Placement turn;
  if (turn_by_axis) {
    turn = turn_about(unit_or({p[3], p[4], p[5]}, {0, 1, 0}), p[6]);
  } else {
    const Placement x = turn_about({1, 0, 0}, p[3]), y = turn_about({0, 1, 0}, p[4]), z = turn_about({0, 0, 1}, p[5]);
    const auto turned = [&](Vec3 v) { return z.turn(y.turn(x.turn(v))); };
    const Vec3 a = turned({1, 0, 0}), b = turned({0, 1, 0}), c = turned({0, 0, 1});
    turn.rows = {{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}};
  }
  for (Vec3& row : turn.rows) row = {row.x * p[7], row.y * p[8], row.z * p[9]};
  turn.translation = {p[0], p[1], p[2]};
  return turn;
}

CurveRecord MeshCurve::record(std::uint16_t default_material) const {
  const auto flags =
      static_cast<std::uint8_t>((closed ? CurveRecord::kClosed : 0) | (smooth ? CurveRecord::kSmooth : 0));
  return {first_corner,
          point_count,
          kind,
          flags,
          static_cast<std::uint16_t>(std::lround(16 * width)),
          material == kNone ? default_material : static_cast<std::uint16_t>(material)};
}

std::int32_t add_obj(SceneDescription& scene, const ObjMesh& obj, const std::string& name, const std::string& place,
                     MeshShading shading) {
  MeshSource mesh{name, place, obj.positions, obj.normals, obj.corners, {}, {}, {}, {}};
  std::map<std::pair<std::int32_t, Shading>, std::int32_t>
      made;  // material of the file and shading, to that of the scene
  mesh.faces.reserve(obj.faces.size());
  for (const ObjFace& face : obj.faces) {
    const std::pair key(face.material, shading_of(obj, face, shading));
    const auto [found, is_new] = made.try_emplace(key, static_cast<std::int32_t>(scene.materials.size()));
    if (is_new) {
      MaterialSpec material;
      material.shading = key.second;
      if (face.material != kNone) {
        material.name = obj.materials[static_cast<std::size_t>(face.material)].name;
        material.color = obj.materials[static_cast<std::size_t>(face.material)].color;
        material.transmission = obj.materials[static_cast<std::size_t>(face.material)].transmission;
      }
      scene.materials.push_back(material);
    }
    mesh.faces.push_back({face.first_corner, face.corner_count, 0, 1, found->second});
  }
  scene.meshes.push_back(std::move(mesh));
  return static_cast<std::int32_t>(scene.meshes.size()) - 1;
}

SceneDescription describe_obj(const std::string& path, MeshShading shading) {
  SceneDescription scene;
  scene.place = path;
  InstanceSpec instance;
  instance.mesh = add_obj(scene, read_obj(path), "mesh", path, shading);
  scene.instances.push_back(instance);
  return scene;
}

}  // namespace spanline::host
