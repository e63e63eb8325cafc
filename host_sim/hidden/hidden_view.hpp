// Hidden surfaces removed from a scene: the visible pieces of its faces.
#pragma once

#include "hidden/facet_list.hpp"

namespace spanline::host {

struct ScreenVertex {
  area::GridPoint at;  // 1/16 px, y down
  double depth;        // 0 … 65536, larger is nearer
};

struct VisiblePolygon {
  std::uint16_t facet;                           // into the FacetList
  std::vector<std::vector<ScreenVertex>> rings;  // the outline, then its holes
};

struct HiddenView {
  std::vector<VisiblePolygon> polygons;  // never overlapping; in the order of their facets
  std::uint32_t clips = 0, windows = 0;
};

// `window`: polygons in a window at most, 0 for one window. Throws InputError (naming `place`) where a view is too
// intricate even for the smallest window.
HiddenView remove_hidden(const FacetList& facets, std::uint16_t width, std::uint16_t height, std::uint32_t window,
                         const std::string& place);

}  // namespace spanline::host
