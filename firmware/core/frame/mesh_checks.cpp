#include "core/frame/mesh_lines.hpp"
#include "core/shade/light_hue.hpp"

// Apart from mesh_lines.cpp: plain scenes ask none of this, and texts go with the file that they are in.
namespace spanline {

[[gnu::cold]] Status check_meshes(const SceneView& scene) {
  const SceneRecord& record = scene.scene();
  if (!record.reaches.empty()) return bad_record("SceneRecord", "reaches");
  if (scene.layered()) return bad_record("SceneRecord", "surface detail or see-through materials");
  for (InstanceCursor at(record); !at.at_end(); at.next()) {
    const std::uint16_t flags = at.instance().flags;
    if ((flags & InstanceRecord::kHidden) != 0) continue;
    if ((flags & (InstanceRecord::kTwoSided | InstanceRecord::kScreen)) != 0) {
      return bad_record("InstanceRecord", "flags", at.index(), flags);
    }
    if (at.mesh().fans.empty()) return bad_record("MeshRecord", "fans", at.instance().mesh);
  }
  return {};
}

[[gnu::cold]] Status check_smooth(const SceneRecord& scene) {
  const std::uint32_t materials = scene.materials.size();
  if (materials > FaceLook::kUnknown) return bad_record("SceneRecord", "materials", 0, materials);
  bool gouraud = false;
  for (const MaterialRecord& material : scene.materials) {
    gouraud = gouraud || material.shading == MaterialRecord::kGouraud;
  }
  // A smooth triangle would need more than its brightness.
  if (gouraud && !LightHue::is_one(scene)) return bad_record("LightRecord", "intensity (of several hues)");
  return {};
}

}  // namespace spanline
