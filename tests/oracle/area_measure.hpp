// The clipper's twin: areas of even-odd regions by slabs, without any topology. Between two neighbouring abscissae of
// vertices and crossings no two edges cross, so each slab is a pile of trapezoids.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace spanline::oracle {

struct AreaPoint {
  std::int64_t x, y;
  friend bool operator==(const AreaPoint&, const AreaPoint&) = default;
  friend auto operator<=>(const AreaPoint&, const AreaPoint&) = default;
};
using AreaRing = std::vector<AreaPoint>;   // not closed: the last point joins the first
using AreaRegion = std::vector<AreaRing>;  // even-odd over all rings

// The area of the places that `wanted` accepts: bit i of its argument says whether regions[i] covers the place. In long
// double: the error is below 1e-9 for coordinates within ±32767 and a thousand edges.
long double measure(const std::vector<AreaRegion>& regions, const std::function<bool(unsigned)>& wanted);

// Even-odd membership of a point given in half units, so that it can be kept off all edges: exact. `on_border` is set
// where the point lies on an edge.
bool covers(const AreaRegion& region, AreaPoint twice, bool& on_border);

// The sum of all edges' lengths.
long double perimeter(const AreaRegion& region);

}  // namespace spanline::oracle
