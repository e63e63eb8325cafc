#include "assetc/emit_cpp.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "assetc/fixed_point.hpp"

namespace spanline::host {
namespace {

constexpr const char* kIncludes = "#include <cstdint>\n\n#include \"core/scene/format.hpp\"\n\n";

// Lines of at most 120 columns, `items` separated by commas.
class Table {
 public:
  Table(std::ostringstream& out, const std::string& type, const std::string& name, std::size_t count) : out_(out) {
    out_ << "constexpr " << type << " " << name << "[" << count << "] = {";
  }
  ~Table() { out_ << "};\n"; }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  void add(const std::string& item) {
    constexpr std::size_t kColumns = 118;
    if (column_ + item.size() > kColumns) column_ = 0;
    out_ << (column_ == 0 ? "\n    " : " ") << item << ",";
    column_ = (column_ == 0 ? 4 : column_ + 1) + item.size() + 1;
  }

 private:
  std::ostringstream& out_;
  std::size_t column_ = 1000;  // the first item opens a line
};

template <typename... Numbers>
std::string braces(Numbers... numbers) {
  std::ostringstream out;
  const char* separator = "{";
  ((out << separator << +numbers, separator = ", "), ...);
  out << "}";
  return out.str();
}

template <typename T, typename Text>
void emit_table(std::ostringstream& out, const std::string& type, const std::string& name, const std::vector<T>& items,
                Text text) {
  if (items.empty()) return;
  Table table(out, type, name, items.size());
  for (const T& item : items) table.add(text(item));
}

std::string slice_of(const std::string& name, std::size_t count) { return count == 0 ? "{}" : name; }

template <int F>
std::string fixed3(const Fixed<F> (&v)[3]) {
  return "{" + braces(v[0].raw) + ", " + braces(v[1].raw) + ", " + braces(v[2].raw) + "}";
}

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
      << "extern const spanline::CameraRecord camera;\n";
  return out.str();
}

std::string rgb(Color c) { return braces(c.r, c.g, c.b); }

void emit_mesh_tables(std::ostringstream& out, const MeshTables& mesh, const std::string& suffix) {
  const auto normal = [](Normal10 n) { return braces(n.packed); };
  const auto number = [](std::uint16_t n) { return std::to_string(n); };
  emit_table(out, "spanline::Position", "kPositions" + suffix, mesh.positions,
             [](const Position& p) { return braces(p.x, p.y, p.z); });
  emit_table(out, "spanline::Normal10", "kVertexNormals" + suffix, mesh.vertex_normals, normal);
  emit_table(out, "spanline::Normal10", "kFaceNormals" + suffix, mesh.face_normals, normal);
  emit_table(out, "std::uint16_t", "kCorners" + suffix, mesh.corners, number);
  emit_table(out, "std::uint16_t", "kContours" + suffix, mesh.contours, number);
  emit_table(out, "std::uint16_t", "kParents" + suffix, mesh.parents, number);
  emit_table(out, "spanline::FaceGroup", "kGroups" + suffix, mesh.groups, [](const FaceGroup& g) {
    return braces(g.first_corner, g.first_face, g.face_count, g.corners_per_face, g.first_contour, g.contour_count,
                  g.material);
  });
  emit_table(out, "std::uint16_t", "kFanStarts" + suffix, mesh.fan_starts, number);
  emit_table(out, "spanline::FanEdge", "kFans" + suffix, mesh.fans,
             [](const FanEdge& e) { return braces(e.to, e.face, e.twin); });
  emit_table(out, "spanline::CurveRecord", "kCurves" + suffix, mesh.curves, [](const CurveRecord& c) {
    constexpr const char* kKinds[] = {"kBezier", "kQuadratic", "kBSpline", "kCatmullRom"};
    return "{" + std::to_string(c.first_corner) + ", " + std::to_string(c.point_count) +
           ", spanline::CurveRecord::" + kKinds[c.kind] + ", " + std::to_string(c.flags) + ", " +
           std::to_string(c.width) + ", " + std::to_string(c.material) + "}";
  });
}

// A name as a C++ string literal; what is not plain ASCII becomes '_'.
std::string literal(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c >= ' ' && c <= '~' && c != '"' && c != '\\' ? c : '_';
  return out + "\"";
}

std::string mesh_record(const MeshTables& mesh, const std::string& suffix) {
  std::ostringstream out;
  out << "{" << literal(mesh.name) << ", " << slice_of("kPositions" + suffix, mesh.positions.size()) << ", "
      << slice_of("kVertexNormals" + suffix, mesh.vertex_normals.size()) << ", "
      << slice_of("kFaceNormals" + suffix, mesh.face_normals.size()) << ", "
      << slice_of("kCorners" + suffix, mesh.corners.size()) << ", "
      << slice_of("kContours" + suffix, mesh.contours.size()) << ", "
      << slice_of("kGroups" + suffix, mesh.groups.size()) << ", " << mesh.face_count << ", " << fixed3(mesh.origin)
      << ", " << mesh.unit << ", " << slice_of("kFanStarts" + suffix, mesh.fan_starts.size()) << ", "
      << slice_of("kFans" + suffix, mesh.fans.size()) << ", " << slice_of("kCurves" + suffix, mesh.curves.size())
      << ", " << slice_of("kParents" + suffix, mesh.parents.size()) << "}";
  return out.str();
}

std::string instance_record(const InstanceRecord& instance) {
  const Transform& t = instance.transform;
  std::ostringstream out;
  out << "{" << instance.mesh << ", " << instance.flags << ", " << instance.material << ", {{" << fixed3(t.matrix[0])
      << ", " << fixed3(t.matrix[1]) << ", " << fixed3(t.matrix[2]) << "}, " << fixed3(t.translation) << "}}";
  return out.str();
}

void emit_meshes(std::ostringstream& out, const std::vector<MeshTables>& meshes) {
  for (std::size_t i = 0; i < meshes.size(); ++i) emit_mesh_tables(out, meshes[i], std::to_string(i));
  Table table(out, "spanline::MeshRecord", "kMeshes", meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) table.add(mesh_record(meshes[i], std::to_string(i)));
}

void emit_scene(std::ostringstream& out, const CompiledScene& scene) {
  const SceneRecord record = scene.record();
  out << "constinit const spanline::SceneRecord scene = {\n    kMeshes, kInstances, kMaterials, "
      << slice_of("kLights", record.lights.size()) << ",\n    "
      << braces(record.ambient[0], record.ambient[1], record.ambient[2]) << ", {" << rgb(record.background.top) << ", "
      << rgb(record.background.bottom) << "}, " << slice_of("kReaches", record.reaches.size()) << "};\n\n";
  const CameraRecord& camera = scene.camera();
  out << "constinit const spanline::CameraRecord camera = {\n    " << fixed3(camera.eye) << ",\n    {"
      << fixed3(camera.axes[0]) << ",\n     " << fixed3(camera.axes[1]) << ",\n     " << fixed3(camera.axes[2])
      << "},\n    " << braces(camera.focal.raw) << ", " << braces(camera.near_plane.raw) << ", "
      << braces(camera.far_plane.raw) << "};\n";
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
  std::ostringstream out;
  out << "// Made by `spanline assets`; do not edit.\n";
  if (header.empty()) {
    out << kIncludes << "namespace " << name << " {\n" << declarations(scene);
  } else {
    out << "#include \"" << header << "\"\n\nnamespace " << name << " {\n";
  }
  out << "namespace {\n\n";
  emit_meshes(out, scene.meshes());
  emit_table(out, "spanline::InstanceRecord", "kInstances", scene.instances(), instance_record);
  emit_table(out, "spanline::MaterialRecord", "kMaterials", scene.materials(), [](const MaterialRecord& m) {
    constexpr const char* kNames[] = {"kFlat", "kGouraud", "kUnlit"};
    return "{" + rgb(m.color) + ", spanline::MaterialRecord::" + kNames[m.shading] + ", " + rgb(m.transmission) + ", " +
           std::to_string(m.reach) + "}";
  });
  emit_table(out, "spanline::LightRecord", "kLights", scene.lights(), [](const LightRecord& light) {
    return "{" + fixed3(light.direction) + ", " + braces(light.intensity[0], light.intensity[1], light.intensity[2]) +
           "}";
  });
  emit_table(out, "spanline::ReachRecord", "kReaches", scene.description().reaches, [](const ReachRecord& reach) {
    std::string lights;
    for (const Rgb8& light : reach.light) lights += (lights.empty() ? "" : ", ") + rgb(light);
    return "{{" + lights + "}}";
  });
  out << "\n}  // namespace\n\n";
  emit_scene(out, scene);
  out << "\n}  // namespace " << name << "\n";
  return out.str();
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
