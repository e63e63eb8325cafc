// The curves of docs/scene.md: strokes, isocurves of patches.
#pragma once

#include <functional>

#include "assetc/json_node.hpp"
#include "assetc/scene_description.hpp"

namespace spanline::host {

// The number of the material that a node names; fails where there is none.
using MaterialOf = std::function<std::int32_t(const JsonNode&)>;

// Appends what "curves" lists to the mesh; `material`: of those that name none. Throws InputError.
void read_curves(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of);

// Appends the faces that "outlines" lists. Throws InputError.
void read_outlines(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of);

// Appends the isocurves of a patch file. Throws InputError.
void read_isocurves(const JsonNode& node, MeshSource& mesh, std::int32_t material, const MaterialOf& material_of);

}  // namespace spanline::host
