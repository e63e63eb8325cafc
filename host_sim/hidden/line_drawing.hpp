// Hidden lines removed: the borders between what is visible, each once.
#pragma once

#include "hidden/hidden_view.hpp"

namespace spanline::host {

struct Line {
  area::GridPoint from, to;  // 1/16 px, y down
};

// The lines between visible polygons of different faces and along the background. Straight runs are one line; window
// borders, which divide one face, are none.
std::vector<Line> visible_lines(const HiddenView& view);

// The parts of all edges of `all` (fronts and backs) that no visible line runs along.
std::vector<Line> hidden_lines(const FacetList& all, const std::vector<Line>& visible, std::uint16_t width,
                               std::uint16_t height);

}  // namespace spanline::host
