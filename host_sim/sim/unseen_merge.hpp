// Merging coplanar faces where nobody can see it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "assetc/compile.hpp"

namespace spanline::host {

struct UnseenMerge {
  std::vector<std::string> kept_apart;  // names of the meshes that would have shown
  std::size_t pictures = 0;             // that were compared for each mesh
};

// Merges the meshes of `scene` one after the other, each with at most `most_corners` a face (merge.hpp). Depths of a
// larger face are rounded anew: where something pierces or touches it, a pixel may change hands. So the scene is drawn
// before and after, from all around and in frames of its motion, and a mesh that changes any pixel stays as it was.
UnseenMerge merge_unseen(CompiledScene& scene, std::uint32_t most_corners);

}  // namespace spanline::host
