// The vertices of one mesh on the screen, each projected when it is asked for.
#pragma once

#include "core/geom/projection.hpp"

namespace spanline {

struct MeshPoints {
  const Position* positions = nullptr;
  Projection projection{CameraRecord{}, Screen{}};
  Normaliser normaliser;
  ClipRows to_clip;

  MeshPoints() = default;
  MeshPoints(const CameraRecord& camera, const Screen& screen) : projection(camera, screen) {}

  ScreenXY operator[](std::uint32_t vertex) { return projection.place(to_clip(positions[vertex]), normaliser); }
};

// The same for assembly; a vertex inside all planes.
PackedXY place_vertex(MeshPoints& points, std::uint32_t vertex) asm("spanline_place_vertex");

}  // namespace spanline
