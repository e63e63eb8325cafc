// Surface detail of a mesh: faces that lie on another face, its parent, and are seen wherever that is (seed 2). They
// are the last faces of the mesh; MeshSource::parents has the parent of each.
#pragma once

#include <string>
#include <vector>

#include "assetc/scene_description.hpp"

namespace spanline::host {

// Whether a face lies in the plane of another, within a thousandth of the parent's size.
bool lies_on(const MeshSource& mesh, const MeshFace& parent, const MeshFace& detail);

// Makes all detail run round the way that its parent does: its direction is nobody's business, but the engine culls by
// it.
void turn_detail(MeshSource& mesh);

// Makes surface detail of all faces whose material has one of these names: they go to the end, in their order, each on
// the face below its middle. The mesh has none so far. Throws InputError for a name that no face has, for a face with
// nothing below it, and where no other faces are left.
void set_detail(MeshSource& mesh, const std::vector<MaterialSpec>& materials, const std::vector<std::string>& names);

// Throws InputError where see-through detail lies on an opaque face. `materials` are those of the scene, the last one
// of faces without one.
void check_detail(const MeshSource& mesh, const std::vector<MaterialSpec>& materials);

}  // namespace spanline::host
