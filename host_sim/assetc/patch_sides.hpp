// Which side of a patch is out, where its file does not say.
#pragma once

#include "assetc/scene_description.hpp"

namespace spanline::host {

// Turns patches over, so that all turn the same side out: neighbours along a whole side of four control points agree,
// and of the patches that hang together most of what they enclose lies behind them. `mesh` has patches only.
void turn_patches_out(MeshSource& mesh);

}  // namespace spanline::host
