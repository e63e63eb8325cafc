// Flat outlines in the x-y plane made solid along z.
#pragma once

#include "mesh.hpp"

namespace spanline::make {

using Ring = std::vector<Vec>;  // z is not used; the material lies on the left of each edge

// Appends points of a circle's arc, both ends included, in `steps` equal steps; angles in radians, either direction.
void arc(Ring& ring, Vec centre, double radius, double from, double to, int steps);

// Front (towards +z) and back face of one simple polygon, at z = half and z = -half.
void caps(Mesh& mesh, const Ring& ring, double half);

// The wall along a closed ring from -half to half. Bends of less than 40 degrees are smooth, others are creases.
void walls(Mesh& mesh, const Ring& ring, double half);

// One ring out of an outline and a hole in it: a bridge edge, run to and fro, joins outline[from] with hole[to].
Ring bridged(const Ring& outline, const Ring& hole, std::size_t from, std::size_t to);

}  // namespace spanline::make
