// The faces of a scene as the area sort takes them: plane polygons on the screen's 1/16 pixel grid, in the colour that
// the engine gives them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assetc/compile.hpp"
#include "core/area/area_sort.hpp"
#include "core/geom/facet.hpp"

namespace spanline::host {

struct Facet {
  std::uint32_t face;  // its number in the scene
  std::vector<std::vector<FacetVertex>> rings;
  area::Box bounds;
  Rgb8 color;
  Rgb8 transmission;                   // as MaterialRecord has it; all 0: opaque
  std::vector<std::uint16_t> details;  // facets that lie on this one
  bool two_sided;                      // seen from both sides, or of a mesh on the screen
  std::optional<area::Plane> plane{};  // where it is not told from the rings: of a part of a see-through face
};

enum class Facing { as_culled, all };

// Whether what is seen of a convex solid goes into the sort as one silhouette (the seed's consolidation).
enum class Solids { whole, face_by_face };

// A scene for area::WindowSort, which knows nothing of surface detail and of solids: the former comes with the face
// that it lies on, and a solid's faces come together. Detail of a see-through face is cut out of it and stands beside
// it. Where a face has more than three corners and they do not lie in one plane, the plane of its largest triangle
// stands for it.
class FacetList {
 public:
  // What `scene` shows in its present frame. A Gouraud face has the colour of its face normal.
  FacetList(const CompiledScene& scene, Facing facing, Solids solids = Solids::whole);

  // Of what goes into the sort at once: a face with its detail, or a solid.
  std::uint32_t count() const { return static_cast<std::uint32_t>(units_.size()); }
  const area::Box& bounds(std::uint16_t i) const { return units_[i].bounds; }
  void put(std::uint16_t i, area::AreaSort& sort) const;

  std::uint32_t hosts() const { return hosts_; }  // facets that are no detail of another

  const std::vector<Facet>& facets() const { return facets_; }
  const Facet& operator[](std::size_t i) const { return facets_[i]; }

 private:
  struct Unit {
    std::vector<std::uint16_t> facets;
    area::Box bounds = area::Box::none();
  };

  void lay_on_panes(std::map<std::uint16_t, std::vector<Facet>>& details, const std::string& place);
  void lay_on_opaque(std::map<std::uint16_t, std::vector<Facet>>& details);
  void put_face(std::uint16_t facet, area::AreaSort& sort) const;
  void make_units(const std::vector<std::int32_t>& solid_of_face);

  std::vector<Facet> facets_;  // detail of opaque ones comes last
  std::vector<Unit> units_;
  std::uint32_t hosts_ = 0;  // facets before
};

}  // namespace spanline::host
