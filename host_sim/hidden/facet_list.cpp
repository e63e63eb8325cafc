#include "hidden/facet_list.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "assetc/input_error.hpp"
#include "assetc/sort_memory.hpp"
#include "core/shade/light.hpp"
#include "hidden/convex_solids.hpp"
#include "hidden/laid_detail.hpp"
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

// Hands a facet's contours to the sort.
void put_rings(const Facet& facet, area::AreaSort& sort) {
  for (const std::vector<FacetVertex>& ring : facet.rings) {
    sort.begin_contour();
    for (const FacetVertex& v : ring) sort.vertex(v.at.x, v.at.y, static_cast<std::int32_t>(v.depth));
    sort.end_contour();
  }
  sort.end_polygon();
}

Rgb8 colour_of(const FacetReader& reader, const SceneRecord& scene, bool front) {
  const MeshRecord& mesh = reader.mesh();
  const FaceRef& face = reader.face();
  const MaterialRecord& material = scene.materials[face.material];
  if (material.shading == MaterialRecord::kUnlit) return material.color;
  const Normal10& normal =
      mesh.face_normals.empty() ? mesh.vertex_normals[face.corners[0]] : mesh.face_normals[face.mesh_face];
  return LightRig(scene, reader.instance().transform).shade(normal, material, !front);
}

SolidFace solid_face(const FacetReader& reader) {
  SolidFace face{reader.instance_index(), {}};
  if (reader.is_patch()) return face;
  for (const std::uint16_t corner : reader.face().corners) face.corners.push_back(reader.mesh().positions[corner]);
  return face;
}

}  // namespace

FacetList::FacetList(const CompiledScene& scene, Facing facing, Solids solids) {
  SceneRecord record = scene.record();
  std::vector<InstanceRecord> instances(record.instances.begin(), record.instances.end());
  if (facing == Facing::all) {
    for (InstanceRecord& instance : instances) instance.flags |= InstanceRecord::kTwoSided;
  }
  record.instances = {instances.data(), static_cast<std::uint32_t>(instances.size())};
  const SceneView view = validated(record, scene.description().place);
  FacetReader reader(view, scene.camera(), {scene.description().width, scene.description().height}, {});
  std::map<std::uint16_t, std::vector<Facet>> details;  // by the face that they lie on
  std::vector<SolidFace> all;
  for (std::uint32_t face = 0; face < view.face_count(); ++face) {
    reader.select(static_cast<std::uint16_t>(face));
    if (solids == Solids::whole) all.push_back(solid_face(reader));
    const FacetExtent extent = reader.extent();
    if ((extent.left >= extent.right && extent.first_line >= extent.end_line) || extent.area == 0) continue;
    const MaterialRecord& material = record.materials[reader.face().material];
    const bool two_sided = reader.on_screen() || (reader.instance().flags & InstanceRecord::kTwoSided) != 0;
    Facet facet{face, {},       area::Box::none(), colour_of(reader, record, extent.front()), material.transmission,
                {},   two_sided};
    Collect collect{facet};
    reader.read([](std::uint16_t) { return Rgb8{}; }, collect);
    if (reader.parent() == kNoFace) {
      facets_.push_back(std::move(facet));
    } else {
      details[reader.parent()].push_back(std::move(facet));
    }
  }
  lay_on_panes(details, scene.description().place);
  hosts_ = static_cast<std::uint32_t>(facets_.size());
  lay_on_opaque(details);
  make_units(convex_solids(all));
}

void FacetList::lay_on_panes(std::map<std::uint16_t, std::vector<Facet>>& details, const std::string& place) {
  std::optional<SortMemory> memory;
  const std::size_t faces = facets_.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const auto on_it = details.find(static_cast<std::uint16_t>(facets_[i].face));
    if (facets_[i].transmission == Rgb8{} || on_it == details.end()) continue;
    if (!memory) memory.emplace();
    if (!DetailLayer(memory->refs().clipper).lay(facets_[i], on_it->second).ok()) {
      throw InputError(place, "is too intricate: the detail on face " + std::to_string(facets_[i].face));
    }
    std::move(on_it->second.begin(), on_it->second.end(), std::back_inserter(facets_));
    details.erase(on_it);
  }
}

void FacetList::lay_on_opaque(std::map<std::uint16_t, std::vector<Facet>>& details) {
  for (std::uint32_t i = 0; i < hosts_; ++i) {
    const auto on_it = details.find(static_cast<std::uint16_t>(facets_[i].face));
    if (on_it == details.end()) continue;
    for (Facet& detail : on_it->second) {
      facets_[i].details.push_back(static_cast<std::uint16_t>(facets_.size()));
      facets_.push_back(std::move(detail));
    }
  }
}

// A solid of opaque faces without detail that are culled goes into the sort as one.
void FacetList::make_units(const std::vector<std::int32_t>& solid_of_face) {
  std::map<std::int32_t, std::size_t> unit_of;
  std::set<std::int32_t> apart;
  const auto solid_of = [&](const Facet& facet) {
    return facet.face < solid_of_face.size() ? solid_of_face[facet.face] : kNoSolid;
  };
  for (std::uint32_t i = 0; i < hosts_; ++i) {
    const Facet& facet = facets_[i];
    if (!facet.details.empty() || facet.transmission != Rgb8{} || facet.two_sided) apart.insert(solid_of(facet));
  }
  for (std::uint32_t i = 0; i < hosts_; ++i) {
    const std::int32_t solid = solid_of(facets_[i]);
    const bool alone = solid == kNoSolid || apart.contains(solid);
    const std::size_t unit = alone ? units_.size() : unit_of.try_emplace(solid, units_.size()).first->second;
    if (unit == units_.size()) units_.emplace_back();
    units_[unit].facets.push_back(static_cast<std::uint16_t>(i));
    units_[unit].bounds.widen(facets_[i].bounds.low);
    units_[unit].bounds.widen(facets_[i].bounds.high);
  }
}

void FacetList::put(std::uint16_t i, area::AreaSort& sort) const {
  const std::vector<std::uint16_t>& facets = units_[i].facets;
  if (facets.size() == 1) return put_face(facets[0], sort);
  sort.begin_group();
  for (const std::uint16_t facet : facets) put_face(facet, sort);
  sort.end_group();
}

void FacetList::put_face(std::uint16_t i, area::AreaSort& sort) const {
  const bool clear = facets_[i].transmission != Rgb8{};
  const area::Opacity opacity = clear ? area::Opacity::translucent : area::Opacity::opaque;
  if (facets_[i].plane) {
    sort.begin_polygon(i, *facets_[i].plane, opacity);
  } else {
    sort.begin_polygon(i, opacity);
  }
  put_rings(facets_[i], sort);
  for (const std::uint16_t detail : facets_[i].details) {
    sort.begin_detail(detail);
    put_rings(facets_[detail], sort);
  }
}

}  // namespace spanline::host
