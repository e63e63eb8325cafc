// Random scenes for the area sort, and its slow twin: what is seen at a place, by one exact decision a polygon.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/area_measure.hpp"
#include "oracle/random.hpp"

namespace spanline::oracle {

// A plane polygon: even-odd region, depth along_x · x + along_y · y + at_origin in 2^-16 of Q16.8, larger is nearer. At
// every corner the depth is whole and within 0 … 2^24 - 1.
struct SortPolygon {
  std::uint16_t source;
  AreaRegion region;
  std::int64_t along_x, along_y, at_origin;

  std::int64_t value(AreaPoint p) const { return along_x * p.x + along_y * p.y + at_origin; }
};
using SortScene = std::vector<SortPolygon>;

// The picture that random scenes are made for: pixels a line, lines, and units of the grid a pixel. A unit is half of
// the 1/16 pixel grid on which vertices lie.
inline constexpr int kSortColumns = 48, kSortLines = 40, kSortUnits = 32;

// 2 … 30 polygons numbered from 0: loose ones that pierce each other, layers, coplanar ones that touch and overlap,
// bars in a cycle, interlocked combs (one polygon both in front of and behind another), and meshes of triangles.
SortScene random_sort_scene(std::uint64_t seed);

// The source seen at `p`, -1 for none: the nearest polygon that covers it, the lowest source where depths are equal.
int seen_at(const SortScene& scene, AreaPoint p);

}  // namespace spanline::oracle
