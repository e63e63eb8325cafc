// Hidden surfaces removed from a scene: the visible pieces of its faces.
#pragma once

#include "hidden/facet_list.hpp"

namespace spanline::host {

struct ScreenVertex {
  area::GridPoint at;  // 1/16 px, y down
  double depth;        // 0 … 65536, larger is nearer
};

struct VisiblePolygon {
  std::uint16_t facet;                           // into the FacetList; area::kBackdrop: the background behind films
  std::vector<std::uint16_t> films;              // see-through facets in front of it, from front to back
  Rgb8 color{};                                  // through them; where they are shown, its own
  Rgb8 transmission{};                           // where films are shown and this is one
  std::vector<std::vector<ScreenVertex>> rings;  // the outline, then its holes
};

inline bool looks_like(const VisiblePolygon& a, const VisiblePolygon& b) {
  return a.facet == b.facet && a.color == b.color;
}

struct HiddenView {
  std::vector<VisiblePolygon> polygons;  // in the order of their facets and colours
  std::uint32_t clips = 0, windows = 0;  // runs of the clipper, windows sorted
};

// `window`: polygons in a window at most, 0 for one window. Where panes are named the polygons do not overlap, and what
// is seen through see-through faces, the background too, has its colour through them; where they are shown, see-through
// faces are polygons that overlap what lies behind, and everything has its own colour. Throws InputError where a view
// is too intricate even for the smallest window.
HiddenView remove_hidden(const FacetList& facets, const SceneDescription& scene, std::uint32_t window,
                         area::Panes panes);

}  // namespace spanline::host
