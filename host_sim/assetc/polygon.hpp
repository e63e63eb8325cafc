// Normals of polygons and of the vertices between them.
#pragma once

#include <vector>

#include "assetc/scene_description.hpp"

namespace spanline::host {

// Newell's normal of the face's first ring: twice its area long, towards the side from which it runs counter-clockwise.
// Zero where the ring has no area.
Vec3 newell_normal(const MeshSource& mesh, const MeshFace& face);

// For each position, the sum of the normals of the faces around it: area-weighted. Not of unit length. Surface detail
// counts only where it has corners of its own.
std::vector<Vec3> position_normals(const MeshSource& mesh);

}  // namespace spanline::host
