// What a frame of the edge walker consists of, counted by plain geometry: what its stages' costs are divided by.
#pragma once

#include <cstdint>

#include "core/geom/screen.hpp"
#include "core/scene/scene_view.hpp"

namespace spanline::bench {

struct Units {
  std::uint32_t vertices = 0, faces = 0;  // of all instances
  std::uint32_t fronts = 0;               // faces that are drawn
  std::uint32_t edges = 0;                // of those, shared ones once, that cross the centre of a line
  std::uint32_t edge_lines = 0;           // lines crossed, over all edges
  std::uint32_t overlaps = 0;             // runs of columns between two edges of a line that several faces cover
  std::uint32_t overlapping = 0;          // faces that have a part in one: their depth planes are made
};

// Triangle meshes with fans, all in view; nothing of others.
Units units_of(const SceneView& view, const CameraRecord& camera, const Screen& screen);

}  // namespace spanline::bench
