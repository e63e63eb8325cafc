#include "hidden/facet_list.hpp"

#include "core/shade/light.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

struct Collect {
  Facet& facet;
  void begin_contour() { facet.rings.emplace_back(); }
  void vertex(const FacetVertex& v) {
    facet.rings.back().push_back(v);
    facet.bounds.widen({v.at.x, v.at.y});
  }
  void end_contour() {}
};

Rgb8 colour_of(const FacetReader& reader, const SceneRecord& scene, bool front) {
  const MeshRecord& mesh = reader.mesh();
  const FaceRef& face = reader.face();
  const MaterialRecord& material = scene.materials[face.material];
  if (material.shading == MaterialRecord::kUnlit) return material.color;
  const Normal10& normal =
      mesh.face_normals.empty() ? mesh.vertex_normals[face.corners[0]] : mesh.face_normals[face.mesh_face];
  return LightRig(scene, reader.instance().transform).shade(normal, material, !front);
}

}  // namespace

FacetList::FacetList(const CompiledScene& scene, Facing facing) {
  SceneRecord record = scene.record();
  std::vector<InstanceRecord> instances(record.instances.begin(), record.instances.end());
  if (facing == Facing::all) {
    for (InstanceRecord& instance : instances) instance.flags |= InstanceRecord::kTwoSided;
  }
  record.instances = {instances.data(), static_cast<std::uint32_t>(instances.size())};
  const SceneView view = validated(record, scene.description().place);
  FacetReader reader(view, scene.camera(), {scene.description().width, scene.description().height}, {});
  for (std::uint32_t face = 0; face < view.face_count(); ++face) {
    reader.select(static_cast<std::uint16_t>(face));
    const FacetExtent extent = reader.extent();
    if ((extent.left >= extent.right && extent.first_line >= extent.end_line) || extent.area == 0) continue;
    Facet facet{face, {}, area::Box::none(), colour_of(reader, record, extent.front())};
    Collect collect{facet};
    reader.read([](std::uint16_t) { return Rgb8{}; }, collect);
    facets_.push_back(std::move(facet));
  }
}

void FacetList::put(std::uint16_t i, area::AreaSort& sort) const {
  sort.begin_polygon(i);
  for (const std::vector<FacetVertex>& ring : facets_[i].rings) {
    sort.begin_contour();
    for (const FacetVertex& v : ring) sort.vertex(v.at.x, v.at.y, static_cast<std::int32_t>(v.depth));
    sort.end_contour();
  }
  sort.end_polygon();
}

}  // namespace spanline::host
