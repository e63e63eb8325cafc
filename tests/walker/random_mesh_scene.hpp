// Random scenes of triangle meshes with fans, before a camera: what the edge walker is for.
#pragma once

#include <deque>
#include <vector>

#include "assetc/compile.hpp"
#include "core/geom/screen.hpp"

namespace spanline::test {

// A scene that owns its records.
struct MeshScene {
  std::deque<host::MeshTables> meshes;
  std::vector<MeshRecord> mesh_records;
  std::vector<InstanceRecord> instances;
  std::vector<MaterialRecord> materials;
  std::vector<LightRecord> lights;
  std::uint16_t ambient[3] = {64, 64, 64};
  CameraRecord camera;
  Screen screen;

  SceneRecord record();
};

// Soups of triangles over few vertices, folded sheets, closed bodies, slivers, faces drawn twice; some of them in
// several places, which pierce each other, reach over the screen's sides, are larger than the screen or smaller than
// a pixel; half of them in light of a hue.
MeshScene random_mesh_scene(std::uint64_t seed);

}  // namespace spanline::test
