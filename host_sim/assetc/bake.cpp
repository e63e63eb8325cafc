#include "assetc/bake.hpp"

#include <map>

#include "assetc/baked_mesh.hpp"
#include "assetc/face_plane.hpp"
#include "assetc/input_error.hpp"
#include "assetc/polygon.hpp"
#include "assetc/shadow_parts.hpp"

namespace spanline::host {
namespace {

bool takes_part(const SceneDescription& scene, const InstanceSpec& instance) {
  const bool of_patches = scene.meshes[static_cast<std::size_t>(instance.mesh)].of_patches();
  return instance.shadows && !instance.hidden && !instance.on_screen && !of_patches;
}

const MaterialSpec& material_of(const SceneDescription& scene, const InstanceSpec& instance, const MeshFace& face) {
  const std::int32_t given = instance.material == kNone ? face.material : instance.material;
  return given == kNone ? scene.materials.back() : scene.materials[static_cast<std::size_t>(given)];
}

bool is_mirrored(const Placement& place) { return dot(place.rows[0], cross(place.rows[1], place.rows[2])) < 0; }

std::size_t surface_count(const MeshSource& mesh) { return mesh.faces.size() - mesh.parents.size(); }

// Everything that throws shadows and takes light: the faces of one instance after those of another.
struct LitScene {
  std::vector<LitFace> faces;
  std::vector<std::size_t> first;  // of each instance
};

LitScene lit_scene(const SceneDescription& scene, std::int64_t frame) {
  LitScene all;
  for (const InstanceSpec& instance : scene.instances) {
    all.first.push_back(all.faces.size());
    if (!takes_part(scene, instance)) continue;
    const Placement place = instance.placement(frame);
    const MeshSource& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    for (std::size_t f = 0; f < surface_count(mesh); ++f) {
      LitFace face{rings_of(mesh, mesh.faces[f]),
                   FacePlane::of(mesh, mesh.faces[f]),
                   {},
                   material_of(scene, instance, mesh.faces[f]).transmission};
      if (face.plane) face.own = face.plane->region(face.rings);
      for (Ring3& ring : face.rings) {
        for (Vec3& p : ring) p = place(p);
      }
      all.faces.push_back(std::move(face));
    }
  }
  return all;
}

class Baker {
  static constexpr double kGrazing = 1.0 / 256;  // such light is no grey level, and what it sees has no width
  static constexpr double kCoarsest = FacePlane::kMargin / 8.0;

 public:
  Baker(const SceneDescription& scene, std::int64_t frame)
      : scene_(scene), out_(scene), frame_(frame), clipper_(scene.place), lit_(lit_scene(scene, frame)) {
    for (const LightSpec& light : *scene.lights) {
      directions_.push_back(unit_or(light.direction, {0, 0, -1}));
      views_.push_back(find_lit_parts(lit_.faces, directions_.back(), scene.place));
    }
  }

  SceneDescription run() {
    out_.meshes.clear();
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) bake_instance(i);
    out_.materials.push_back(scene_.materials.back());  // the last one is of faces without any
    return std::move(out_);
  }

 private:
  void bake_instance(std::size_t index) {
    const InstanceSpec& instance = scene_.instances[index];
    const MeshSource& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    if (takes_part(scene_, instance)) {
      BakedMesh baked(mesh, clipper_);
      const Placement place = instance.placement(frame_);
      for (std::size_t f = 0; f < surface_count(mesh); ++f) bake_face(index, f, place, baked);
      if (baked.changed()) {
        out_.instances[index].material = kNone;
        out_.instances[index].mesh = static_cast<std::int32_t>(out_.meshes.size());
        out_.meshes.push_back(baked.take());
        return;
      }
    }
    const auto [kept, is_new] = kept_.try_emplace(instance.mesh, static_cast<std::int32_t>(out_.meshes.size()));
    if (is_new) out_.meshes.push_back(mesh);
    out_.instances[index].mesh = kept->second;
  }

  void bake_face(std::size_t index, std::size_t face, const Placement& place, BakedMesh& baked) {
    const InstanceSpec& instance = scene_.instances[index];
    const MeshSource& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    const auto name = [&](const MeshFace& of, const ReachRecord& reach) {
      return material_with(material_of(scene_, instance, of), reach);
    };
    const LitFace& lit = lit_.faces[lit_.first[index] + face];
    const Shading shading = material_of(scene_, instance, mesh.faces[face]).shading;
    if (!lit.plane || shading == Shading::kUnlit) return baked.keep(face, name);
    ShadowParts parts(lit.own, clipper_);
    for (std::size_t l = 0; l < directions_.size(); ++l) {
      const double slope = slope_to(*lit.plane, place, directions_[l]);
      if (instance.cull && slope <= 0 && shading != Shading::kGouraud) continue;
      if (std::fabs(slope) < kGrazing) continue;
      const double own = length(place.turn(lit.plane->right()));
      const auto grain = std::lround(std::min(kCoarsest, 1 + 2 * views_[l].unit / (own * std::fabs(slope))));
      parts.add_light(l, views_[l].of_face[lit_.first[index] + face], static_cast<std::int32_t>(grain));
    }
    baked.add(face, *lit.plane, parts.finish(), name);
  }

  // The cosine between the way to the light and the face's normal on the side that is seen.
  static double slope_to(const FacePlane& plane, const Placement& place, Vec3 direction) {
    const Vec3 normal = unit_or(cross(place.turn(plane.right()), place.turn(plane.up())), {});
    return is_mirrored(place) ? dot(normal, direction) : -dot(normal, direction);
  }

  // The number of `material` where the lights reach it so.
  std::int32_t material_with(MaterialSpec material, const ReachRecord& reach) {
    const std::size_t channels = 3 * directions_.size();
    std::vector<std::uint8_t> key;
    for (const Rgb8& light : reach.light) key.insert(key.end(), {light.r, light.g, light.b});
    const bool all = std::all_of(key.begin(), key.begin() + static_cast<std::ptrdiff_t>(channels),
                                 [](std::uint8_t part) { return part == 255; });
    if (!all) {
      const auto [found, is_new] = reaches_.try_emplace(key, static_cast<std::uint16_t>(out_.reaches.size()));
      if (is_new) out_.reaches.push_back(reach);
      material.reach = found->second;
    }
    for (std::size_t i = 0; i + 1 < out_.materials.size(); ++i) {
      const MaterialSpec& known = out_.materials[i];
      if (known.name == material.name && known.color == material.color && known.shading == material.shading &&
          known.transmission == material.transmission && known.reach == material.reach) {
        return static_cast<std::int32_t>(i);
      }
    }
    out_.materials.push_back(material);
    return static_cast<std::int32_t>(out_.materials.size()) - 1;
  }

  const SceneDescription& scene_;
  SceneDescription out_;
  std::int64_t frame_;
  RegionClipper clipper_;
  LitScene lit_;
  std::vector<Vec3> directions_;
  std::vector<LitParts> views_;                // of each light
  std::map<std::int32_t, std::int32_t> kept_;  // meshes that came through as they were
  std::map<std::vector<std::uint8_t>, std::uint16_t> reaches_;
};

}  // namespace

SceneDescription bake_shadows(const SceneDescription& scene, std::int64_t frame) {
  if (!scene.lights || scene.lights->empty()) {
    throw InputError(scene.place, "shadows need lights: without 'lights' there is but one that goes with the viewer");
  }
  return Baker(scene, frame).run();
}

bool shadows_move(const SceneDescription& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const InstanceSpec& instance) {
    return takes_part(scene, instance) && !instance.motion.keys.empty();
  });
}

}  // namespace spanline::host
