#include "assetc/emit_cpp.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "assetc/emit_records.hpp"
#include "assetc/fixed_point.hpp"

namespace spanline::host {
namespace {

constexpr const char* kIncludes = "#include <cstdint>\n\n#include \"core/scene/scene_view.hpp\"\n\n";

std::string declarations(const CompiledScene& scene) {
  Fx16 target[3];
  put(target, scene.fit()(scene.view().target));
  std::string origins;
  for (const MeshFit& fit : scene.mesh_fits()) {
    Fx16 origin[3];
    put(origin, fit(Vec3{}));
    origins += "\n    " + fixed3(origin) + ",";
  }
  std::ostringstream out;
  out << "inline constexpr std::uint16_t kWidth = " << scene.description().width << ";    // px\n"
      << "inline constexpr std::uint16_t kHeight = " << scene.description().height << ";  // px\n"
      << "inline constexpr spanline::Fx16 kTarget[3] = " << fixed3(target) << ";  // world, what the camera looks at\n"
      << "// For each mesh, the origin of its own coordinates as the records have them: what turns about it needs to "
         "know.\n"
      << "inline constexpr spanline::Fx16 kOrigins[][3] = {" << origins << "};\n"
      << "extern const spanline::SceneRecord scene;\n"
      << "extern const spanline::SceneView view;  // of it\n"
      << "extern const spanline::CameraRecord camera;\n";
  return out.str();
}

}  // namespace

std::string identifier_from(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) name.insert(0, "scene_");
  return name;
}

std::string emit_header(const CompiledScene& scene, const std::string& name) {
  return std::string("// Made by `spanline assets`; do not edit.\n#pragma once\n\n") + kIncludes + "namespace " + name +
         " {\n\n" + declarations(scene) + "\n}  // namespace " + name + "\n";
}

std::string emit_source(const CompiledScene& scene, const std::string& name, const std::string& header) {
  std::string out = "// Made by `spanline assets`; do not edit.\n";
  if (header.empty()) {
    out += kIncludes + ("namespace " + name) + " {\n" + declarations(scene);
  } else {
    out += "#include \"" + header + "\"\n\nnamespace " + name + " {\n";
  }
  return out + emit_records(scene.record(), scene.camera()) +
         "\nconstinit const spanline::SceneView view = spanline::SceneView::of_compiled(scene);\n\n}  // namespace " +
         name + "\n";
}

TableSizes table_sizes(const CompiledScene& scene) {
  TableSizes sizes;
  for (const MeshTables& mesh : scene.meshes()) {
    sizes.faces += mesh.face_count;
    sizes.corners += mesh.corners.size();
    for (const FaceGroup& group : mesh.groups) {
      sizes.most_corners = std::max(sizes.most_corners, std::size_t{group.corners_per_face});
    }
    sizes.positions += mesh.positions.size() * sizeof(Position);
    sizes.normals += (mesh.vertex_normals.size() + mesh.face_normals.size()) * sizeof(Normal10);
    sizes.indices += (mesh.corners.size() + mesh.contours.size() + mesh.parents.size()) * sizeof(std::uint16_t);
    sizes.groups += mesh.groups.size() * sizeof(FaceGroup);
    sizes.fans += mesh.fan_starts.size() * sizeof(std::uint16_t) + mesh.fans.size() * sizeof(FanEdge);
    sizes.curves += mesh.curves.size() * sizeof(CurveRecord);
  }
  constexpr std::size_t kMeshBytes = 4 + 10 * 8 + 4 + 12 + 4;  // pointers and sizes are 4 bytes there
  sizes.records = scene.meshes().size() * kMeshBytes + scene.instances().size() * sizeof(InstanceRecord) +
                  scene.materials().size() * sizeof(MaterialRecord) + scene.lights().size() * sizeof(LightRecord) +
                  scene.description().reaches.size() * sizeof(ReachRecord);
  return sizes;
}

std::string emit_report(const CompiledScene& scene, const TableSizes& before) {
  const TableSizes sizes = table_sizes(scene);
  std::ostringstream out;
  out << "meshes     " << scene.meshes().size() << "\n"
      << "faces      " << sizes.faces << " of " << sizes.corners << " corners, at most " << sizes.most_corners
      << " in one; before merging " << before.faces << " of " << before.corners << "\n";
  const auto row = [&](const char* what, std::size_t bytes) { out << what << bytes << " bytes\n"; };
  row("positions  ", sizes.positions);
  row("normals    ", sizes.normals);
  row("indices    ", sizes.indices);
  row("groups     ", sizes.groups);
  row("fans       ", sizes.fans);
  row("curves     ", sizes.curves);
  row("records    ", sizes.records);
  out << "total      " << sizes.total() << " bytes; before merging " << before.total() << "\n";
  out << "one unit of the scene is " << scene.fit().scale << " world units about (" << scene.fit().centre.x << ", "
      << scene.fit().centre.y << ", " << scene.fit().centre.z << ")\n";
  return out.str();
}

}  // namespace spanline::host
