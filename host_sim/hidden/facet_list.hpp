// The faces of a scene as the area sort takes them: plane polygons on the screen's 1/16 pixel grid, in the colour that
// the engine gives them.
#pragma once

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
};

enum class Facing { as_culled, all };

// A scene for area::WindowSort, which knows nothing of surface detail: that comes with the face that it lies on. Detail
// of a see-through face is left out. Where a face has more than three corners and they do not lie in one plane, the
// plane of its largest triangle stands for it.
class FacetList {
 public:
  // What `scene` shows in its present frame. A Gouraud face has the colour of its face normal.
  FacetList(const CompiledScene& scene, Facing facing);

  std::uint32_t count() const { return hosts_; }
  const area::Box& bounds(std::uint16_t i) const { return facets_[i].bounds; }
  void put(std::uint16_t i, area::AreaSort& sort) const;

  const std::vector<Facet>& facets() const { return facets_; }
  const Facet& operator[](std::size_t i) const { return facets_[i]; }

 private:
  std::vector<Facet> facets_;  // detail comes last
  std::uint32_t hosts_ = 0;    // facets before
};

}  // namespace spanline::host
