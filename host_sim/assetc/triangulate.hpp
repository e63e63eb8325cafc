// Faces cut into triangles, which is what the edge walker draws.
#pragma once

#include <optional>
#include <string>

#include "assetc/compile.hpp"

namespace spanline::host {

// Faces of more corners than this are left alone: cutting takes time in the square of them, or worse.
inline constexpr std::size_t kMostCutCorners = 1024;

// The same mesh with every face cut into triangles by ear clipping, holes bridged to their outlines first, in exact
// arithmetic on the grid of positions; of all ears the one with the shortest diagonal goes first. No vertex is made, so
// neighbours still meet, and every triangle keeps the normal and the material of its face: outlines and flat colours
// stay as they are. Depths and Gouraud colours within a face of more than three corners become those of triangles,
// where they were straight between its edges on each line. Triangles stand in the places of their faces, which numbers
// faces anew. Nothing where that cannot be: of patches, curved outlines, meshes on the screen or with surface detail,
// and where a face crosses itself. `place` is for messages. Throws InputError where 16-bit indices do not suffice.
std::optional<MeshTables> triangulate(const MeshTables& mesh, const std::string& place);

}  // namespace spanline::host
