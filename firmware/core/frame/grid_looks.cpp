#include "core/frame/grid_looks.hpp"

#include "core/frame/mesh_lines.hpp"
#include "core/shade/light_hue.hpp"

namespace spanline {

[[gnu::cold]] GridLooks::GridLooks(const FrameStorage& storage) : cache_(storage.smooth, storage.screen.format) {}

[[gnu::cold]] Status GridLooks::begin_frame(const SceneView& scene) {
  scene_ = &scene.scene();
  on_ = false;
  if (!cache_.on()) return {};
  const Slice<const MaterialRecord>& materials = scene_->materials;
  if (materials.size() > FaceLook::kUnknown) return {Code::bad_record, "SceneRecord", "materials"};
  bool any = false;
  for (InstanceCursor at(*scene_); !at.at_end(); at.next()) {
    if ((at.instance().flags & InstanceRecord::kHidden) != 0) continue;
    for (const FaceGroup& group : at.mesh().groups) {
      const std::uint16_t number = material_of(at.instance(), group);
      const bool smooth = materials[number].shading == MaterialRecord::kGouraud;
      if (any && smooth != on_) return {Code::bad_record, "MaterialRecord", "shading (some are Gouraud)", number};
      material_ = !any || material_ == number ? number : FaceLook::kNoMaterial;
      any = true;
      on_ = smooth;
    }
  }
  // A smooth cell would need more than its brightness.
  if (on_ && !LightHue::is_one(*scene_)) return {Code::bad_record, "LightRecord", "intensity (of several hues)"};
  return {};
}

void GridLooks::begin(PatchGrids& grids) {
  cache_.clear();
  brush_ = Brush(cache_.looks(), {&grids[0]});
  grids.set_background(0);  // its look is the first
}

const FaceLook& GridLooks::learn(FaceId face, PatchGrids& grids, FacetReader& reader) {
  std::uint8_t slot = grids.look(face);
  const FaceLook& look = cache_.look(face, slot, [&](FaceId unknown, FaceLook& to) {
    std::uint16_t material = material_;
    if (material == FaceLook::kNoMaterial) {
      reader.select(grids.scene_face(unknown));
      material = reader.face().material;
    }
    to = {grids.brightness(unknown), unknown, material};
  });
  grids.set_look(face, slot);
  if (!brush_.knows(face, look)) brush_.dip(look.material, cache_.colors(look.material, *scene_));
  return look;
}

}  // namespace spanline
