// OBJ files that are on the screen already (--screen).
#include <array>
#include <cmath>

#include "assetc/input_error.hpp"
#include "assetc/polygon.hpp"
#include "assetc/scene_description.hpp"

namespace spanline::host {
namespace {

constexpr int kHues = 4;     // so that neighbours in the file differ
constexpr int kShades = 16;  // by slope, so that the form shows

void check_whole(const ObjMesh& obj, const std::string& path) {
  for (std::size_t i = 0; i < obj.positions.size(); ++i) {
    const Vec3 p = obj.positions[i];
    const auto check = [&](const char* axis, double value, double low, double high) {
      if (value == std::floor(value) && value >= low && value <= high) return;
      throw InputError(path, obj.position_lines[i],
                       std::string(axis) + " is not a whole number from " + std::to_string(static_cast<int>(low)) +
                           " to " + std::to_string(static_cast<int>(high)));
    };
    check("x", p.x, -32768, 32767);
    check("y", p.y, -32768, 32767);
    check("z", p.z, 0, 65535);
  }
}

// Four hues by sixteen shades; material hue * kShades + shade.
std::vector<MaterialSpec> palette() {
  constexpr std::array<Vec3, kHues> hues = {
      {{0.95, 0.80, 0.55}, {0.60, 0.80, 0.98}, {0.70, 0.92, 0.65}, {0.97, 0.66, 0.62}}};
  std::vector<MaterialSpec> materials;
  for (const Vec3& hue : hues) {
    for (int shade = 0; shade < kShades; ++shade) {
      const double light = 0.25 + 0.75 * shade / (kShades - 1);
      materials.push_back(
          {"", {channel(hue.x * light), channel(hue.y * light), channel(hue.z * light)}, Shading::kUnlit});
    }
  }
  return materials;
}

// Brightness 0 … 15 of a face under a light over the left shoulder, depth stretched to the picture's size.
int shade_of(const MeshSource& mesh, const MeshFace& face, double depth_scale) {
  const Vec3 slope = newell_normal(mesh, face);  // y is down and z towards the viewer: fronts come out with z < 0
  const Vec3 towards = unit_or({slope.x * depth_scale, slope.y * depth_scale, slope.z}, {0, 0, 1});
  const Vec3 light = unit_or({-0.4, -0.6, 0.7}, {0, 0, 1});
  const double facing = dot(towards.z < 0 ? -1 * towards : towards, light);
  return static_cast<int>(std::lround(std::clamp(facing, 0.0, 1.0) * (kShades - 1)));
}

// The span of z for the span of x and y, so that the form is as deep as wide.
double depth_scale(const ObjMesh& obj) {
  Box box;
  for (const Vec3& p : obj.positions) box.add(p);
  const Vec3 half = box.half();
  return half.z > 0 ? std::max(half.x, half.y) / half.z : 1;
}

}  // namespace

SceneDescription describe_screen_obj(const std::string& path) {
  const ObjMesh obj = read_obj(path);
  check_whole(obj, path);
  SceneDescription scene;
  scene.place = path;
  if (obj.materials.empty()) scene.materials = palette();
  InstanceSpec instance;
  instance.on_screen = true;
  instance.mesh = add_obj(scene, obj, "mesh", path, MeshShading::unlit);
  if (obj.materials.empty()) {
    MeshSource& mesh = scene.meshes[0];
    const double scale = depth_scale(obj);
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      const int hue = static_cast<int>(i % kHues);
      mesh.faces[i].material = hue * kShades + shade_of(mesh, mesh.faces[i], scale);
    }
  }
  scene.instances.push_back(instance);
  return scene;
}

}  // namespace spanline::host
