#include "core/geom/projection.hpp"

namespace spanline {

bool Projection::well_inside(const PositionBox& box, const ClipRows& to_clip) const {
  for (unsigned i = 0; i < 8; ++i) {
    if (!well_inside(to_clip(box.corner(i)))) return false;
  }
  return true;
}

bool Projection::well_inside(Slice<const Position> positions, const ClipRows& to_clip) const {
  for (const Position& position : positions) {
    if (!well_inside(to_clip(position))) return false;
  }
  return true;
}

}  // namespace spanline
