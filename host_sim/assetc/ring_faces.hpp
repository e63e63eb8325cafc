// The faces of compiled tables as rings of vertices, whatever group they stand in.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assetc/compile.hpp"
#include "assetc/grid_plane.hpp"

namespace spanline::host {

using Ring = std::vector<std::uint16_t>;  // vertex numbers, closed by itself

// Twice the area of a ring as a vector (Newell), towards the side from which it runs counter-clockwise.
GridVector newell(const Ring& ring, const std::vector<Position>& positions);

// Whether, seen along `normal`, no two edges of the rings cross, overlap in one direction, or touch but with their
// ends.
bool are_simple(const std::vector<Ring>& rings, const std::vector<Position>& positions, GridVector normal);

// A face of polygons; the first ring is its outline.
struct RingFace {
  std::vector<Ring> rings;
  std::uint16_t material = 0;
  bool curved = false;  // FaceGroup::kCurved
  GridVector normal;    // of the first ring
};

// The faces of a mesh in their order; there are no patches among them.
std::vector<RingFace> ring_faces(const MeshTables& mesh);

// Appends rings as a face behind those of `out`, whose positions they number. `place` is for messages. Throws
// InputError where 16-bit indices do not suffice.
void append_rings(MeshTables& out, const std::vector<Ring>& rings, std::uint16_t material, bool curved,
                  const std::string& place);

}  // namespace spanline::host
