// Bezier patches as a mesh: each is a face of sixteen corners, its control points.
#pragma once

#include <string>
#include <vector>

#include "assetc/bpt.hpp"
#include "assetc/json_node.hpp"
#include "assetc/scene_description.hpp"

namespace spanline::host {

// Appends a mesh of patches and its material to `scene`; the index of the new mesh. Control points in the same place
// become one. `automatic` shading is Gouraud's, as for any curved surface.
std::int32_t add_patches(SceneDescription& scene, const std::vector<BptPatch>& patches, const std::string& name,
                         const std::string& place, MeshShading shading);

// One instance of a patch file, seen by the default camera. Both sides are drawn: patch files do not say which is out.
SceneDescription describe_bpt(const std::string& path, MeshShading shading);

// Appends to `mesh`, whose positions stand, the patches of a JSON list: each is sixteen indices of positions.
void read_inline_patches(const JsonNode& node, MeshSource& mesh, std::int32_t material);

}  // namespace spanline::host
