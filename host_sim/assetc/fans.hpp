// The fans of a triangle mesh: what the edge walker reads instead of faces (core/scene/format.hpp, FanEdge).
#pragma once

#include "assetc/compile.hpp"

namespace spanline::host {

// Fills fan_starts and fans from the corners. An edge pairs a face that runs along it with one that runs back; edges
// of one face, or of faces beyond such a pair, have one face. Leaves both tables empty where a face is no triangle or
// there are more faces, edges or neighbours of a vertex than fans may have.
void build_fans(MeshTables& mesh);

}  // namespace spanline::host
