// The placements of docs/scene.md, at rest and in motion.
#pragma once

#include "assetc/json_node.hpp"
#include "assetc/scene_description.hpp"

namespace spanline::host {

// `matrix`, or `translate`, `rotate`, `scale` and `motion` of an instance. Throws InputError.
void read_placement(const JsonNode& node, InstanceSpec& instance);

// The value of "camera". Throws InputError.
void read_camera(const JsonNode& node, CameraSpec& camera);

}  // namespace spanline::host
