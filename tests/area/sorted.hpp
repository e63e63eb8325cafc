// The area sort as the tests use it: scenes in, visible pieces out.
#pragma once

#include <vector>

#include "area/solved.hpp"
#include "core/area/area_sort.hpp"
#include "oracle/sort_random.hpp"

namespace spanline::area::test {

struct VisiblePiece {
  std::uint16_t source;
  Plane plane;
  std::vector<std::uint16_t> films;  // from front to back
  Polygon polygon;
  AreaRegion rings;  // the same, as one region
};
using VisiblePieces = std::vector<VisiblePiece>;

struct Sorted {
  Status status;
  SortCounts counts;
  VisiblePieces pieces;
};

// The sink that fills them.
struct Reading {
  VisiblePieces* pieces;
  AreaRing* ring = nullptr;
  bool main = false;

  void begin_piece(std::uint16_t source, const Plane& plane) {
    pieces->push_back({source, plane, {}, {}, {}});
    main = true;
  }
  void film(std::uint16_t source) { pieces->back().films.push_back(source); }
  void begin_contour() {
    Polygon& polygon = pieces->back().polygon;
    ring = main ? &polygon.main : &polygon.holes.emplace_back();
    main = false;
  }
  void vertex(GridPoint p) { ring->push_back({p.x, p.y}); }
  void end_contour() {}
  void end_piece() { pieces->back().rings = rings_of(Polygons{pieces->back().polygon}); }
};

// Reads what a sort has solved.
VisiblePieces read(const AreaSort& sort);

void put(AreaSort& sort, const oracle::SortPolygon& polygon, Opacity opacity = Opacity::opaque);

// With pools far larger than any test needs.
Sorted sort(const oracle::SortScene& scene, const std::vector<std::uint16_t>& translucent = {});

AreaRegion rings_of(const VisiblePieces& pieces);

// Empty, or what is wrong: a contour that is not proper, or pieces that overlap.
std::string flaw(const VisiblePieces& pieces);

// Of a point from a segment.
double distance(AreaPoint at, AreaPoint a, AreaPoint b);

// The source of the piece at `p`, -1 for none; `doubtful` is set where an edge of some piece passes within `reach`
// units.
int seen_at(const VisiblePieces& pieces, AreaPoint p, double reach, bool& doubtful);

}  // namespace spanline::area::test
