// The shapes, one file each. Right-handed, y up, faces counter-clockwise as seen from outside.
#pragma once

#include <istream>
#include <string>

#include "mesh.hpp"

namespace spanline::make {

// The Bezier patches of a .bpt file, z up, diced into `steps` x `steps` quads each, or twice as many triangles.
Mesh dice_patches(const std::string& bpt, int steps, bool triangles);

// The teapot as the listing of seed 3 has it, made from the whole one of a .bpt file: y up, on the ground, and without
// its bottom. Written as a .bpt file.
void write_seed_teapot(const std::string& bpt, std::ostream& out);

// A gear in the x-y plane with a bore, a raised hub that pierces the web, and `holes` round holes in the web (a divisor
// of `teeth`); its faces are concave n-gons from hole to hole. The pitch radius is teeth / 20, so gears of any two
// sizes mesh.
Mesh gear(int teeth, int holes);

// The parts of a round instrument of radius 1 in the x-y plane: the rim round its glass, the dial, on it a scale of
// coloured zones and ticks from 135 degrees left of the top to 135 right of it, and the needle, pointing up, that turns
// before them.
Mesh gauge_rim();
Mesh gauge_dial();
Mesh gauge_scale();
Mesh gauge_needle();

// A ring about the y axis: 2 * `along` * `around` triangles, closed.
Mesh torus(int along, int around);

// A tube along the (2, 3) torus knot: `along` x `around` quads.
Mesh torus_knot(int along, int around);

// The word SPAN, extruded. P and A have a hole, joined to the outline by a bridge edge, since OBJ has no holes.
Mesh letters();

// Three cubes turned against each other about one centre: every face is pierced.
Mesh penetrating_cubes();

// A floor of `squares` x `squares` in two materials, from -1 to 1 in x and z.
Mesh checkered_floor(int squares);

// A die of side 2; the pips are faces of their own that lie on its sides, after them in the file.
Mesh die(const std::string& body, const std::string& pips);

// A house with gables on a lawn, and two firs; windows, door and path are faces that lie on others, in layers.
Mesh house();

// Hills and a lake of `cells` x `cells` split quads, each triangle flat, coloured by height and slope.
Mesh landscape(int cells);

}  // namespace spanline::make
