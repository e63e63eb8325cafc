// The rows of seed 1's Fig. 33 as one JSON object.
#pragma once

#include <string>
#include <vector>

#include "assetc/scene_description.hpp"
#include "sim/engine.hpp"

namespace spanline::host {

// The faces of a scene and their distinct edges over all instances that are drawn, before culling. Faces share an edge
// where they share the two vertices of the file.
struct SceneCounts {
  std::size_t polygons = 0;
  std::size_t edges = 0;
  std::vector<bool> is_patch;  // by face number, hidden ones too
};
SceneCounts count_scene(const SceneDescription& scene);

// Ends in a newline.
std::string stats_json(const SceneCounts& counts, const Rendering& rendering, const PoolSizes& pools);

}  // namespace spanline::host
