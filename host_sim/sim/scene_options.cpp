#include "sim/scene_options.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "assetc/camera.hpp"
#include "assetc/patch_mesh.hpp"
#include "assetc/scene_json.hpp"
#include "sim/arguments.hpp"
#include "sim/usage_error.hpp"

namespace spanline::host {
namespace {

MeshShading parse_shading(const std::string& text) {
  if (text == "flat") return MeshShading::flat;
  if (text == "gouraud") return MeshShading::gouraud;
  throw UsageError("--shading: '" + text + "' is not one of flat, gouraud");
}

// Shades what every material of a scene colours in one way, unlit ones excepted.
void reshade(SceneDescription& scene, MeshShading shading) {
  for (MaterialSpec& material : scene.materials) {
    if (material.shading == Shading::kUnlit) continue;
    material.shading = shading == MeshShading::flat ? Shading::kFlat : Shading::kGouraud;
  }
}

}  // namespace

void SceneOptions::add_to(CLI::App& verb) {
  verb.add_option("SCENE", scene_, "an .obj, a .bpt or a scene .json (docs/scene.md)")->required();
  verb.add_option("--size", size_, "WxH in pixels, at most 2046 each (default: the scene's, or 320x240)");
  verb.add_option("--eye", eye_, "x,y,z of the viewer (default: the bounding sphere fits 90 % of the height)");
  verb.add_option("--target", target_, "x,y,z of the point in the middle of the picture (default: the scene's centre)");
  verb.add_option("--up", up_, "x,y,z of what is up (default: 0,1,0)");
  verb.add_option("--fov", fov_, "vertical angle of view, degrees (default: 45)");
  verb.add_option("--near", near_, "nothing nearer is drawn (default: in front of the bounding sphere)");
  verb.add_option("--far", far_, "nothing farther is drawn (default: behind the bounding sphere)");
  verb.add_option("--light", light_, "x,y,z, the way light travels (default: over the viewer's left shoulder)");
  verb.add_option("--shading", shading_, "flat or gouraud for everything that is lit (default: as the scene says)");
  verb.add_flag("--no-cull", no_cull_, "draw backs too");
}

void SceneOptions::lay_camera_over(CameraSpec& camera) const {
  if (!camera_given()) return;
  camera.motion = {};
  if (eye_) camera.eye = parse_vector("--eye", *eye_);
  if (target_) camera.target = parse_vector("--target", *target_);
  if (up_) camera.up = parse_vector("--up", *up_);
  camera.has_eye = camera.has_eye || eye_;
  camera.has_target = camera.has_target || target_;
  if (fov_) camera.fov = parse_real("--fov", *fov_);
  if (!(camera.fov > 0 && camera.fov < 180)) throw UsageError("--fov: must be above 0 and below 180");
  if (near_) camera.near = parse_real("--near", *near_);
  if (far_) camera.far = parse_real("--far", *far_);
  if (camera.near && *camera.near <= 0) throw UsageError("--near: must be above 0");
  if (camera.far && *camera.far <= camera.near.value_or(0)) throw UsageError("--far: must be greater than --near");
  if (!camera.has_eye || !camera.has_target) return;
  if (const char* fault = view_fault(camera.eye, camera.target, camera.up)) throw UsageError(fault);
}

SceneDescription SceneOptions::read(bool on_screen) const {
  const std::string extension = std::filesystem::path(scene_).extension().string();
  const MeshShading shading = shading_ ? parse_shading(*shading_) : MeshShading::automatic;
  if (extension == ".obj") return on_screen ? describe_screen_obj(scene_) : describe_obj(scene_, shading);
  if (on_screen) throw UsageError("--screen: SCENE must be an .obj");
  if (extension == ".bpt") return describe_bpt(scene_, shading);
  if (extension != ".json") throw UsageError(scene_ + ": is none of .obj, .bpt and scene .json");
  SceneDescription scene = read_scene(scene_);
  if (shading_) reshade(scene, shading);
  return scene;
}

SceneDescription SceneOptions::load_plain(const std::string& path) {
  SceneOptions plain;
  plain.scene_ = path;
  return plain.load(false);
}

SceneDescription SceneOptions::load(bool on_screen) const {
  if (on_screen && (camera_given() || light_given())) {
    throw UsageError("--screen: there is no camera and no light to set");
  }
  SceneDescription scene = read(on_screen);
  if (size_) std::tie(scene.width, scene.height) = parse_size("--size", *size_);
  lay_camera_over(scene.camera);
  if (light_) {
    const Vec3 direction = parse_vector("--light", *light_);
    if (largest(direction) == 0) throw UsageError("--light: is zero: it has no direction");
    scene.lights = {{LightSpec{direction}}};
  }
  if (no_cull_) {
    for (InstanceSpec& instance : scene.instances) instance.cull = false;
  }
  return scene;
}

}  // namespace spanline::host
