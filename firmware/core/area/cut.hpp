// Cutting a region along a line: for windows, whose borders are lines of the grid, and for polygons that pierce one
// another.
#pragma once

#include "core/area/borders.hpp"
#include "core/area/plane.hpp"

namespace spanline::area {

// Whether a border has points strictly on both sides of a line.
bool straddles(const Borders& borders, const Border& border, const Line& line);

// Where an edge meets a line; nothing where both ends are on one side. An end on the line counts as on the positive
// side and is itself the place.
struct Meeting {
  bool found = false;
  GridPoint at;
};
Meeting meeting_of(const BorderEdge& edge, const Line& line);

// The points where a closed border meets a line, in their order along it, as the `from` of a list of edges: the first
// and second bound a piece of the line inside the region, the third and fourth the next one.
Border meetings(Borders& borders, const Border& border, const Line& line);

// Cuts `border` (and releases it) into what lies on the positive and on the negative side; the cut is an edge of both.
// No point moves by more than half a unit. The halves' edges are in no order.
struct Halves {
  Border positive, negative;
};
Halves cut(Borders& borders, Border& border, const Line& line);

// Cuts away what lies outside of a box.
void cut_to(Borders& borders, Border& border, const Box& box);

}  // namespace spanline::area
