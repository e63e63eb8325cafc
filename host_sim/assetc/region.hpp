// Regions of a plane on a whole-number grid, and the clipper of core/area on them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/area/clipper.hpp"

namespace spanline::host {

using GridRing = std::vector<area::GridPoint>;

// Even-odd over all rings.
using Region = std::vector<GridRing>;

// A polygon of the clipper's output: the outline and its holes.
using GridPolygon = std::vector<GridRing>;

// Twice the area in grid units of a region whose rings run as the clipper's do.
std::int64_t doubled_area(const Region& region);

// Clips regions. Holds the clipper's pools, as large as 16-bit indices allow.
class RegionClipper {
 public:
  // `place` is for messages: of an InputError where the regions are too intricate for the pools.
  explicit RegionClipper(std::string place);

  struct Split {
    Region inside, outside;
  };
  Split split(const Region& subject, const Region& clip);
  Region unite(const Region& a, const Region& b);

  // Less those of its polygons that are narrower than `width` on average.
  Region without_slivers(const Region& region, std::int32_t width);

  // The region as polygons that touch neither themselves nor each other but in points.
  std::vector<GridPolygon> polygons(const Region& region);

 private:
  void put(const Region& subject, const Region& clip);
  void demand(const Status& status) const;
  Region list(area::List list) const;

  std::string place_;
  std::vector<area::Segment> segments_;
  std::vector<area::Node> nodes_;
  std::vector<area::Edge> edges_;
  std::vector<area::Contour> contours_;
  area::Clipper clipper_;
};

}  // namespace spanline::host
