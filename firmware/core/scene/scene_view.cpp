#include "core/scene/scene_view.hpp"

namespace spanline {

namespace {

constexpr Status bad(const char* record, const char* field, std::uint32_t index, std::uint32_t value = 0,
                     std::uint32_t limit = 0) {
  return {Code::bad_record, record, field, index, 0, value, limit};
}

bool within_world(Fx16 c) { return c <= Fx16::from_int(kMaxWorld) && c >= Fx16::from_int(-kMaxWorld); }

Status check_rings(const MeshRecord& mesh, const FaceGroup& group, std::uint32_t g) {
  if (group.contour_count == FaceGroup::kPatches) {
    const bool sixteen = group.corners_per_face == FaceGroup::kPatchCorners;
    return sixteen ? Status{}
                   : bad("FaceGroup", "corners_per_face", g, group.corners_per_face, FaceGroup::kPatchCorners);
  }
  const std::uint16_t rings = group.rings();
  if (rings == 0) return bad("FaceGroup", "contour_count", g, group.contour_count);
  const auto whole_curves = [&](std::uint32_t corners) {
    return !group.curved() || (corners >= 6 && corners % 3 == 0);
  };
  if (rings == 1) {
    return whole_curves(group.corners_per_face)
               ? Status{}
               : bad("FaceGroup", "corners_per_face (curved)", g, group.corners_per_face);
  }
  const std::uint32_t end = std::uint32_t{group.first_contour} + rings;
  if (end > mesh.contours.size()) return bad("FaceGroup", "first_contour", g, end, mesh.contours.size());
  std::uint32_t sum = 0;
  for (std::uint32_t i = group.first_contour; i < end; ++i) {
    if (mesh.contours[i] < 3) return bad("FaceGroup", "contours", g, mesh.contours[i], 3);
    if (!whole_curves(mesh.contours[i])) return bad("FaceGroup", "contours (curved)", g, mesh.contours[i]);
    sum += mesh.contours[i];
  }
  // Rings that do not add up leave a contour unclosed.
  return sum == group.corners_per_face ? Status{}
                                       : bad("FaceGroup", "contours (unclosed)", g, sum, group.corners_per_face);
}

Status check_group(const SceneRecord& scene, const MeshRecord& mesh, std::uint32_t g, std::uint32_t first_face) {
  const FaceGroup& group = mesh.groups[g];
  if (group.first_face != first_face) return bad("FaceGroup", "first_face", g, group.first_face, first_face);
  if (group.face_count == 0) return bad("FaceGroup", "face_count", g);
  const bool patches = group.contour_count == FaceGroup::kPatches;
  if (patches != mesh.of_patches()) return bad("FaceGroup", "contour_count (polygons and patches)", g);
  if (group.corners_per_face < 3) return bad("FaceGroup", "corners_per_face", g, group.corners_per_face, 3);
  const std::uint64_t end = group.first_corner + std::uint64_t{group.face_count} * group.corners_per_face;
  if (end > mesh.corners.size()) return bad("FaceGroup", "first_corner", g, group.first_corner, mesh.corners.size());
  if (group.material >= scene.materials.size())
    return bad("FaceGroup", "material", g, group.material, scene.materials.size());
  return check_rings(mesh, group, g);
}

// Whether a face is the triangle a, b, c, from whichever corner on.
bool is_triangle(const MeshRecord& mesh, std::uint16_t face, std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  if (face >= mesh.face_count) return false;
  const std::uint16_t* const at = mesh.corners.data() + 3u * face;
  const std::uint32_t first = at[0] == a ? 0 : at[1] == a ? 1 : 2;
  return at[first] == a && at[(first + 1) % 3] == b && at[(first + 2) % 3] == c;
}

// Whether the fan of a vertex goes round it by faces that are its neighbours', none of them twice; counts these.
bool goes_round(const MeshRecord& mesh, std::uint16_t vertex, std::uint32_t& faces) {
  const FanEdge* const begin = mesh.fans.data() + mesh.fan_starts[vertex];
  const FanEdge* const end = mesh.fans.data() + mesh.fan_starts[vertex + 1u];
  if (end - begin > static_cast<std::ptrdiff_t>(FanEdge::kMostInFan)) return false;
  const FanEdge* first = begin;  // of the round
  for (const FanEdge* edge = begin; edge != end; ++edge) {
    if (edge->to == vertex) {
      first = edge + 1;
      continue;
    }
    const bool last = edge + 1 == end || edge[1].to == vertex;
    if (last && (first == begin ? end : first)[-1].face != edge->face) return false;
    if (edge->to >= mesh.positions.size()) return false;
    if (edge->face == FanEdge::kNone) continue;
    if (!is_triangle(mesh, edge->face, vertex, edge->to, (last ? first : edge + 1)->to)) return false;
    for (const FanEdge* other = begin; other != edge; ++other) {
      if (other->face == edge->face && other->to != vertex) return false;
    }
    ++faces;
  }
  return true;
}

// Every corner of every face but degenerate ones is in the fan of its vertex, once, and so are, from either end, the
// sides that run to it and from it: so what the edges begin and end on a line is each face once.
Status check_fans(const MeshRecord& mesh, std::uint32_t index) {
  const std::uint32_t vertices = mesh.positions.size();
  if (mesh.fan_starts.empty() && mesh.fans.empty()) return {};
  if (mesh.fan_starts.size() != vertices + 1 || mesh.fan_starts[0] != 0 ||
      mesh.fan_starts[vertices] != mesh.fans.size()) {
    return bad("MeshRecord", "fan_starts", index, mesh.fan_starts.size(), vertices + 1);
  }
  if (mesh.face_count > FanEdge::kMostFaces) {
    return bad("MeshRecord", "fans (faces)", index, mesh.face_count, FanEdge::kMostFaces);
  }
  for (const FaceGroup& group : mesh.groups) {
    if (group.corners_per_face != 3 || group.first_corner != 3u * group.first_face)
      return bad("MeshRecord", "fans (not all faces are triangles in order)", index);
  }
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (mesh.fan_starts[v] > mesh.fan_starts[v + 1]) return bad("MeshRecord", "fan_starts", index, v);
  }
  std::uint32_t corners = 0, wanted = 0;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (!goes_round(mesh, static_cast<std::uint16_t>(v), corners)) return bad("MeshRecord", "fans", index, v);
  }
  for (std::uint32_t i = 0; i < 3u * mesh.face_count; i += 3) {
    const std::uint16_t* const c = mesh.corners.data() + i;
    if (c[0] != c[1] && c[1] != c[2] && c[2] != c[0]) wanted += 3;
  }
  return corners == wanted ? Status{} : bad("MeshRecord", "fans", index, corners, wanted);
}

Status check_curve(const SceneRecord& scene, const MeshRecord& mesh, std::uint32_t index) {
  const CurveRecord& curve = mesh.curves[index];
  if (curve.kind > CurveRecord::kCatmullRom) return bad("CurveRecord", "kind", index, curve.kind);
  if (curve.pieces() == 0) return bad("CurveRecord", "point_count", index, curve.point_count);
  const std::uint64_t end = std::uint64_t{curve.first_corner} + curve.point_count;
  if (end > mesh.corners.size())
    return bad("CurveRecord", "first_corner", index, curve.first_corner, mesh.corners.size());
  if (curve.width > CurveRecord::kMaxWidth)
    return bad("CurveRecord", "width", index, curve.width, CurveRecord::kMaxWidth);
  if (curve.material >= scene.materials.size())
    return bad("CurveRecord", "material", index, curve.material, scene.materials.size());
  return {};
}

// What a mesh's normals allow as materials.
Status check_material(const MeshRecord& mesh, const MaterialRecord& material, const char* record, std::uint32_t index) {
  const bool normals =
      material.shading == MaterialRecord::kUnlit || mesh.of_patches() ||
      !(material.shading == MaterialRecord::kGouraud ? mesh.vertex_normals : mesh.face_normals).empty();
  return normals ? Status{} : bad(record, "material (no normals)", index);
}

// The material of a face by the mesh's own choice.
const MaterialRecord& material_of(const SceneRecord& scene, const MeshRecord& mesh, std::uint32_t face) {
  std::uint32_t g = 0;
  while (face - mesh.groups[g].first_face >= mesh.groups[g].face_count) ++g;
  return scene.materials[mesh.groups[g].material];
}

// Surface detail lies on faces that are none, and hides or takes the place of its parent's surface: through an opaque
// parent nothing could be seen.
Status check_detail(const SceneRecord& scene, const MeshRecord& mesh, std::uint32_t index) {
  const std::uint32_t count = mesh.parents.size();
  if (count != 0 && mesh.of_patches()) return bad("MeshRecord", "parents (of patches)", index);
  if (count >= mesh.face_count && count != 0) return bad("MeshRecord", "parents", index, count, mesh.face_count - 1u);
  const std::uint32_t first = mesh.face_count - count;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (mesh.parents[i] >= first) return bad("MeshRecord", "parents", index, mesh.parents[i], first - 1);
    if (!material_of(scene, mesh, first + i).see_through()) continue;
    if (!material_of(scene, mesh, mesh.parents[i]).see_through())
      return bad("MeshRecord", "parents (see-through detail on an opaque face)", index, first + i);
  }
  return {};
}

Status check_material_record(const SceneRecord& scene, std::uint32_t index) {
  const MaterialRecord& material = scene.materials[index];
  if (material.shading > MaterialRecord::kUnlit) return bad("MaterialRecord", "shading", index, material.shading);
  if (material.reach != MaterialRecord::kAllLight && material.reach >= scene.reaches.size())
    return bad("MaterialRecord", "reach", index, material.reach, scene.reaches.size());
  return {};
}

Status check_mesh(const SceneRecord& scene, std::uint32_t index) {
  const MeshRecord& mesh = scene.meshes[index];
  if (mesh.positions.empty() || mesh.positions.size() > kMaxSceneVertices) {
    return bad("MeshRecord", "positions", index, mesh.positions.size(), kMaxSceneVertices);
  }
  if (!mesh.vertex_normals.empty() && mesh.vertex_normals.size() != mesh.positions.size()) {
    return bad("MeshRecord", "vertex_normals", index, mesh.vertex_normals.size(), mesh.positions.size());
  }
  if (!mesh.face_normals.empty() && mesh.face_normals.size() != mesh.face_count) {
    return bad("MeshRecord", "face_normals", index, mesh.face_normals.size(), mesh.face_count);
  }
  for (const std::uint16_t corner : mesh.corners) {
    if (corner >= mesh.positions.size()) return bad("MeshRecord", "corners", index, corner, mesh.positions.size());
  }
  for (std::uint32_t v = 0; v < mesh.positions.size() && !mesh.box.holds_all(); ++v) {
    if (!mesh.box.holds(mesh.positions[v])) return bad("MeshRecord", "box", index, v);
  }
  if (mesh.unit <= 0) return bad("MeshRecord", "unit", index);
  for (const Fx16 c : mesh.origin) {
    if (!within_world(c)) return bad("MeshRecord", "origin", index);
  }
  std::uint32_t faces = 0;
  for (std::uint32_t g = 0; g < mesh.groups.size(); ++g) {
    const Status status = check_group(scene, mesh, g, faces);
    if (!status.ok()) return status;
    faces += mesh.groups[g].face_count;
  }
  for (std::uint32_t c = 0; c < mesh.curves.size(); ++c) {
    const Status status = check_curve(scene, mesh, c);
    if (!status.ok()) return status;
  }
  const bool empty = faces == 0 && mesh.curves.empty();
  if (empty || faces != mesh.face_count) return bad("MeshRecord", "face_count", index, mesh.face_count, faces);
  const Status detail = check_detail(scene, mesh, index);
  return detail.ok() ? check_fans(mesh, index) : detail;
}

Status check_instance(const SceneRecord& scene, std::uint32_t index) {
  const InstanceRecord& instance = scene.instances[index];
  if (instance.mesh >= scene.meshes.size())
    return bad("InstanceRecord", "mesh", index, instance.mesh, scene.meshes.size());
  for (const Fx16 c : instance.transform.translation) {
    if (!within_world(c)) return bad("InstanceRecord", "transform.translation", index);
  }
  const MeshRecord& mesh = scene.meshes[instance.mesh];
  const bool own = instance.material == InstanceRecord::kOwnMaterials;
  if (!own && instance.material >= scene.materials.size()) {
    return bad("InstanceRecord", "material", index, instance.material, scene.materials.size());
  }
  const bool on_screen = (instance.flags & InstanceRecord::kScreen) != 0;  // where no light falls
  if (on_screen && mesh.of_patches()) return bad("InstanceRecord", "mesh (patches on the screen)", index);
  for (const FaceGroup& group : mesh.groups) {
    const MaterialRecord& material = scene.materials[own ? group.material : instance.material];
    if (on_screen && material.shading != MaterialRecord::kUnlit)
      return bad("InstanceRecord", "material (screen)", index);
    const Status status = check_material(mesh, material, "InstanceRecord", index);
    if (!status.ok()) return status;
  }
  return {};
}

Status check_light(const LightRecord& light, std::uint32_t index) {
  std::int64_t square = 0;
  for (const Fx30 c : light.direction) square += (std::int64_t{c.raw} * c.raw) >> 30;
  constexpr std::int64_t kSlack = Fx30::kOne >> 8;
  const bool unit = square > Fx30::kOne - kSlack && square < Fx30::kOne + kSlack;
  return unit ? Status{} : bad("LightRecord", "direction", index);
}

}  // namespace

Status SceneView::validate(const SceneRecord& scene, SceneView& view) {
  for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
    const Status status = check_material_record(scene, i);
    if (!status.ok()) return status;
  }
  if (scene.lights.size() > kMaxLights) return bad("SceneRecord", "lights", 0, scene.lights.size(), kMaxLights);
  for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
    const Status status = check_light(scene.lights[i], i);
    if (!status.ok()) return status;
  }
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    const Status status = check_mesh(scene, i);
    if (!status.ok()) return status;
  }
  std::uint32_t faces = 0, vertices = 0, curves = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Status status = check_instance(scene, i);
    if (!status.ok()) return status;
    const MeshRecord& mesh = scene.meshes[scene.instances[i].mesh];
    faces += mesh.face_count;
    vertices += mesh.positions.size();
    curves += mesh.curves.size();
    if (curves > kMaxSceneCurves) return bad("SceneRecord", "instances (curves)", i, curves, kMaxSceneCurves);
    if (faces > kMaxSceneFaces) return bad("SceneRecord", "instances (faces)", i, faces, kMaxSceneFaces);
    if (vertices > kMaxSceneVertices) return bad("SceneRecord", "instances (vertices)", i, vertices, kMaxSceneVertices);
  }
  view = of_compiled(scene);
  return {};
}

}  // namespace spanline
