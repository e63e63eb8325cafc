#include "assetc/emit_records.hpp"

#include <sstream>

namespace spanline::host {
namespace {

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
void emit_table(std::ostringstream& out, const std::string& type, const std::string& name, Slice<const T> items,
                Text text) {
  if (items.empty()) return;
  Table table(out, type, name, items.size());
  for (const T& item : items) table.add(text(item));
}

std::string slice_of(const std::string& name, bool empty) { return empty ? "{}" : name; }

std::string rgb(Rgb8 c) { return braces(c.r, c.g, c.b); }

std::string position(const Position& p) { return braces(p.x, p.y, p.z); }

void emit_mesh_tables(std::ostringstream& out, const MeshRecord& mesh, const std::string& suffix) {
  const auto normal = [](Normal10 n) { return braces(n.packed); };
  const auto number = [](std::uint16_t n) { return std::to_string(n); };
  emit_table(out, "spanline::Position", "kPositions" + suffix, mesh.positions, position);
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
             [](const FanEdge& e) { return braces(e.to, e.face); });
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

std::string mesh_record(const MeshRecord& mesh, const std::string& suffix) {
  std::ostringstream out;
  out << "{" << literal(mesh.name) << ", " << slice_of("kPositions" + suffix, mesh.positions.empty()) << ", "
      << slice_of("kVertexNormals" + suffix, mesh.vertex_normals.empty()) << ", "
      << slice_of("kFaceNormals" + suffix, mesh.face_normals.empty()) << ", "
      << slice_of("kCorners" + suffix, mesh.corners.empty()) << ", "
      << slice_of("kContours" + suffix, mesh.contours.empty()) << ", "
      << slice_of("kGroups" + suffix, mesh.groups.empty()) << ", " << mesh.face_count << ", " << fixed3(mesh.origin)
      << ", " << mesh.unit << ", " << slice_of("kFanStarts" + suffix, mesh.fan_starts.empty()) << ", "
      << slice_of("kFans" + suffix, mesh.fans.empty()) << ", " << slice_of("kCurves" + suffix, mesh.curves.empty())
      << ", " << slice_of("kParents" + suffix, mesh.parents.empty()) << ", {" << position(mesh.box.low) << ", "
      << position(mesh.box.high) << "}}";
  return out.str();
}

std::string instance_record(const InstanceRecord& instance) {
  const Transform& t = instance.transform;
  std::ostringstream out;
  out << "{" << instance.mesh << ", " << instance.flags << ", " << instance.material << ", {{" << fixed3(t.matrix[0])
      << ", " << fixed3(t.matrix[1]) << ", " << fixed3(t.matrix[2]) << "}, " << fixed3(t.translation) << "}}";
  return out.str();
}

void emit_meshes(std::ostringstream& out, Slice<const MeshRecord> meshes) {
  for (std::uint32_t i = 0; i < meshes.size(); ++i) emit_mesh_tables(out, meshes[i], std::to_string(i));
  Table table(out, "spanline::MeshRecord", "kMeshes", meshes.size());
  for (std::uint32_t i = 0; i < meshes.size(); ++i) table.add(mesh_record(meshes[i], std::to_string(i)));
}

}  // namespace

std::string emit_records(const SceneRecord& scene, const CameraRecord& camera) {
  std::ostringstream out;
  out << "namespace {\n\n";
  emit_meshes(out, scene.meshes);
  emit_table(out, "spanline::InstanceRecord", "kInstances", scene.instances, instance_record);
  emit_table(out, "spanline::MaterialRecord", "kMaterials", scene.materials, [](const MaterialRecord& m) {
    constexpr const char* kNames[] = {"kFlat", "kGouraud", "kUnlit"};
    return "{" + rgb(m.color) + ", spanline::MaterialRecord::" + kNames[m.shading] + ", " + rgb(m.transmission) + ", " +
           std::to_string(m.reach) + "}";
  });
  emit_table(out, "spanline::LightRecord", "kLights", scene.lights, [](const LightRecord& light) {
    return "{" + fixed3(light.direction) + ", " + braces(light.intensity[0], light.intensity[1], light.intensity[2]) +
           "}";
  });
  emit_table(out, "spanline::ReachRecord", "kReaches", scene.reaches, [](const ReachRecord& reach) {
    std::string lights;
    for (const Rgb8& light : reach.light) lights += (lights.empty() ? "" : ", ") + rgb(light);
    return "{{" + lights + "}}";
  });
  out << "\n}  // namespace\n\n";
  out << "constexpr spanline::SceneRecord scene = {\n    kMeshes, kInstances, kMaterials, "
      << slice_of("kLights", scene.lights.empty()) << ",\n    "
      << braces(scene.ambient[0], scene.ambient[1], scene.ambient[2]) << ", {" << rgb(scene.background.top) << ", "
      << rgb(scene.background.bottom) << "}, " << slice_of("kReaches", scene.reaches.empty()) << "};\n\n";
  out << "constinit const spanline::CameraRecord camera = {\n    " << fixed3(camera.eye) << ",\n    {"
      << fixed3(camera.axes[0]) << ",\n     " << fixed3(camera.axes[1]) << ",\n     " << fixed3(camera.axes[2])
      << "},\n    " << braces(camera.focal.raw) << ", " << braces(camera.near_plane.raw) << ", "
      << braces(camera.far_plane.raw) << "};\n";
  return out.str();
}

}  // namespace spanline::host
