// How far a scene reaches, over all frames of its motion.
#pragma once

#include <vector>

#include "assetc/scene_description.hpp"

namespace spanline::host {

// The bounding box of the positions that some face of the mesh uses, in the mesh's own units.
Box used_box(const MeshSource& mesh);

// Around the vertices of the instances in the world that are drawn in frame 0: the centre of their bounding box, and
// the distance of the farthest vertex. Radius 0 where nothing is drawn.
Sphere bounding_sphere(const SceneDescription& scene);

// Holds every vertex of every instance in the world in every frame; exact for what stands still. `boxes`: used_box of
// each mesh.
Box reach_of_instances(const SceneDescription& scene, const std::vector<Box>& boxes);

// The largest length of a row of the instance's matrix over all frames.
double largest_stretch(const InstanceSpec& instance);

}  // namespace spanline::host
