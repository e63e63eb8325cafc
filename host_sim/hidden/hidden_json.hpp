#pragma once

#include <string>

#include "hidden/hidden_view.hpp"

namespace spanline::host {

// The visible polygons as a scene file (docs/scene.md) that shows the same picture: a mesh a face, in world coordinates
// and its colour; under `hidden` the same polygons in screen coordinates and what the sort did.
std::string hidden_json(const HiddenView& view, const FacetList& facets, const CompiledScene& scene);

}  // namespace spanline::host
