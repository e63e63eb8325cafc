#pragma once

#include <string>

#include "hidden/line_drawing.hpp"

namespace spanline::host {

// The visible polygons as filled paths, one a face and colour, with the face's number as data-source.
std::string surfaces_svg(const HiddenView& view, const FacetList& facets, const SceneDescription& scene);

// Lines as strokes: `visible` solid, `hidden` dashed.
std::string lines_svg(const std::vector<Line>& visible, const std::vector<Line>& hidden, const SceneDescription& scene);

}  // namespace spanline::host
