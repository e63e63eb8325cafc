#pragma once

#include <cstdint>

#include "core/vsg/comparator.hpp"

namespace spanline {

// How segments are kept in order of X from line to line: the seed's last step (VSG6) or the one before it (VSG5).
enum class XSort : std::uint8_t { list, buckets };

// Who finds the visible spans: seed 1's segment walker, which draws everything; the edge walker, which draws triangle
// meshes with fans that lie inside the view (see EdgeWalker), faster; or the edge walker with the other one to fall
// back on. The picture is the same.
enum class Walker : std::uint8_t { segments, edges, both };

// What the edge walker's spans are painted with: what the storage asks for; or with the code of nothing else,
// fill_span(), or that and smooth_span(), into lines of RGB565.
enum class Paint : std::uint8_t { any, flat_words, smooth_words };

// What is compiled in. A structural type: used as a template argument.
struct VsgOptions {
  Comparator comparator = Comparator::plane;
  XSort x_sort = XSort::list;
  bool statistics = false;  // count what Fig. 33 counts
  bool taps = false;        // spans carry their depth ramp
  bool patches = false;     // Bezier patches are drawn: 10 KB of code and the pools of Budget::patch_facets
  bool points = false;      // patches are plotted as points, not diced: Budget::point_lines; then there are no layers
  bool layers = false;      // surface detail and see-through polygons are drawn: the pools of Budget::layers
  Walker walker = Walker::segments;
  bool bands = false;    // with Walker::edges: of meshes only a band is kept, the storage of Budget::band_vertices
  bool changes = false;  // lines that show what they showed are not drawn again: the storage of Budget::kept_instances
  Paint paint = Paint::any;  // where the walker is that of edges alone
  bool plain = false;        // with Paint::flat_words or smooth_words, of meshes: plain scenes alone, see Budget::plain
};

}  // namespace spanline
