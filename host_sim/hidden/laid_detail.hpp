// Surface detail on see-through faces. The area sort cuts detail out of what is seen of an opaque face; on a
// see-through one it takes the surface's place and may hide what lies behind, so face and details go into the sort as
// what they are: parts of one plane that do not overlap.
#pragma once

#include <vector>

#include "core/area/clipper.hpp"
#include "hidden/facet_list.hpp"

namespace spanline::host {

class DetailLayer {
 public:
  explicit DetailLayer(const area::Pools& pools) : clipper_(pools) {}

  // Cuts the details, the topmost last, to their face and to what those above them leave, and out of the face. All get
  // the face's plane, and may be left without contours. Fails as the clipper does.
  Status lay(Facet& face, std::vector<Facet>& details);

 private:
  area::Clipper clipper_;
};

}  // namespace spanline::host
