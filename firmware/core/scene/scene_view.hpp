#pragma once

#include "core/base/status.hpp"
#include "core/scene/format.hpp"

namespace spanline {

inline constexpr std::uint16_t kNoFace = 65535;

// A scene whose records have been checked once, so that everything behind it reads in place and checks nothing.
class SceneView {
 public:
  SceneView() = default;

  // Checks every record and field of `scene`. On success `view` refers to the records, which must outlive it. On
  // failure the status names the record type, its index, the field and the offending value, and `view` is left as it
  // was.
  static Status validate(const SceneRecord& scene, SceneView& view);

  // A view of records that are known to be what validate() asks for: the scene compiler's (`spanline assets`), which
  // has validated what it writes, and writes the view, too. Leaves 4 KB of checks out of an image that calls nothing
  // else.
  static constexpr SceneView of_compiled(const SceneRecord& scene);

  const SceneRecord& scene() const { return *scene_; }
  std::uint16_t face_count() const { return face_count_; }      // over all instances, hidden ones too
  bool has_patches() const { return has_patches_; }             // some instance is of patches
  std::uint16_t vertex_count() const { return vertex_count_; }  // over all instances
  std::uint16_t curve_count() const { return curve_count_; }    // over all instances, hidden ones too
  bool layered() const { return layered_; }                     // has surface detail or see-through materials
  // What of it is not plain as Budget::plain has it, transforms and normals apart; null: nothing.
  const char* not_plain(bool gouraud) const {
    return gouraud && !all_gouraud_ && not_plain_ == nullptr ? "materials" : not_plain_;
  }

 private:
  const SceneRecord* scene_ = nullptr;
  std::uint16_t face_count_ = 0;
  std::uint16_t vertex_count_ = 0;
  bool has_patches_ = false;
  std::uint16_t curve_count_ = 0;
  bool layered_ = false;
  bool all_gouraud_ = true;  // the materials of its faces
  const char* not_plain_ = nullptr;
};

// What not_plain(false) says.
constexpr const char* what_is_not_plain(const SceneRecord& scene) {
  const auto grey = [](const std::uint16_t(&c)[3]) { return c[0] == c[1] && c[1] == c[2]; };
  if (scene.lights.size() != 1 || !scene.reaches.empty()) return "lights";
  const LightRecord& light = scene.lights[0];
  constexpr std::uint32_t kFull = 256;  // Q8.8
  if (!grey(light.intensity) || !grey(scene.ambient)) return "lights";
  if (light.intensity[0] == 0 || std::uint32_t{light.intensity[0]} + scene.ambient[0] > kFull) return "lights";
  if (scene.background.top != scene.background.bottom) return "background";
  for (const MaterialRecord& material : scene.materials) {
    if (material.see_through()) return "materials";
  }
  for (const MeshRecord& mesh : scene.meshes) {
    if (mesh.fans.empty() || !mesh.parents.empty() || !mesh.curves.empty()) return "meshes";
  }
  for (const InstanceRecord& instance : scene.instances) {
    if ((instance.flags & (InstanceRecord::kTwoSided | InstanceRecord::kScreen)) != 0) return "instances";
  }
  return nullptr;
}

constexpr SceneView SceneView::of_compiled(const SceneRecord& scene) {
  SceneView view;
  view.scene_ = &scene;
  for (const MaterialRecord& material : scene.materials) view.layered_ = view.layered_ || material.see_through();
  for (const MeshRecord& mesh : scene.meshes) view.layered_ = view.layered_ || !mesh.parents.empty();
  for (const InstanceRecord& instance : scene.instances) {
    const MeshRecord& mesh = scene.meshes[instance.mesh];
    view.face_count_ = static_cast<std::uint16_t>(view.face_count_ + mesh.face_count);
    view.vertex_count_ = static_cast<std::uint16_t>(view.vertex_count_ + mesh.positions.size());
    view.curve_count_ = static_cast<std::uint16_t>(view.curve_count_ + mesh.curves.size());
    view.has_patches_ = view.has_patches_ || mesh.of_patches();
    for (const FaceGroup& group : mesh.groups) {
      const bool own = instance.material == InstanceRecord::kOwnMaterials;
      const MaterialRecord& material = scene.materials[own ? group.material : instance.material];
      view.all_gouraud_ = view.all_gouraud_ && material.shading == MaterialRecord::kGouraud;
    }
  }
  view.not_plain_ = what_is_not_plain(scene);
  return view;
}

}  // namespace spanline
