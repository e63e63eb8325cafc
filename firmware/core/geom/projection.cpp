#include "core/geom/projection.hpp"

namespace spanline {

bool Projection::well_inside(const PositionBox& box, const ClipRows& to_clip) const {
  Position corners[8];
  for (unsigned i = 0; i < 8; ++i) corners[i] = box.corner(i);
  return well_inside(Slice<const Position>(corners), to_clip);
}

bool Projection::well_inside(Slice<const Position> positions, const ClipRows& to_clip) const {
  for (const Position& position : positions) {
    if (!well_inside(to_clip(position))) return false;
  }
  return true;
}

void Projection::place(Slice<const Position> positions, const ClipRows& to_clip, ScreenXY* at) const {
  Normaliser normaliser;
  for (const Position& position : positions) *at++ = place(to_clip(position), normaliser);
}

}  // namespace spanline
