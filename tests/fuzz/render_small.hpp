#pragma once

#include "assetc/scene_description.hpp"

namespace spanline::host {

// Compiles the scene and renders frames 0 and 3 of it at 48 x 32 with both comparators, in bands and with few blocks.
// Traps where the pictures differ though nothing was left out, or the compiled records are refused.
void render_small(SceneDescription scene);

}  // namespace spanline::host
