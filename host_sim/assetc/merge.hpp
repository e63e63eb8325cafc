// Coplanar neighbours become one face: fewer facets to wait, to sort and to compare. No outline and no colour changes;
// only where something pierces a merged face may the line move, by less than a pixel, since depths are rounded anew:
// sim/unseen_merge.hpp merges where that does not happen.
#pragma once

#include <string>

#include "assetc/compile.hpp"

namespace spanline::host {

// The same mesh with larger faces. Faces grow together over shared edges where they have the same material and packed
// face normal, where Gouraud shading would be constant over all of them, and where every corner lies within one unit of
// the 16-bit grid of the plane of the largest of them; what comes out may be concave and have holes. Edges that a face
// runs to and fro, as OBJ's bridges to its holes, go as well. Vertices on an outline stay even where it is straight
// there, so that neighbours still meet; a group whose outline would touch itself or overlap is left alone. A merged
// face takes the place of its lowest-numbered part; surface detail stays as
// it is, on the face that its parent has become part of. Meshes on the screen come back as they are. `place` is for
// messages.
//
// All edges of a face wait for their first line at once, 32 bytes each in the engine's edge pool: hence `most_corners`
// of a merged face.
inline constexpr std::uint32_t kMostMergedCorners = 64;
MeshTables merge_coplanar(const MeshTables& mesh, const std::string& place, std::uint32_t most_corners);

}  // namespace spanline::host
