// The clipper as the tests use it: regions in, regions out, and what must hold of every result.
#pragma once

#include <string>
#include <vector>

#include "core/area/clipper.hpp"
#include "oracle/area_measure.hpp"

namespace spanline::area::test {

using oracle::AreaPoint;
using oracle::AreaRegion;
using oracle::AreaRing;

struct Polygon {
  AreaRing main;
  std::vector<AreaRing> holes;
};
using Polygons = std::vector<Polygon>;

enum class Operation { clip, unite, differ };

struct Solved {
  Status status;
  ClipCounts counts;
  Polygons inside, outside;
  std::string broken_link;  // empty where all links between the lists hold

  const Polygons& operator[](List list) const { return list == List::inside ? inside : outside; }
};

void put(Clipper& clipper, Role role, const AreaRegion& region);

// Reads a clipper that has solved.
Solved read(const Clipper& clipper);

// With pools far larger than any test needs.
Solved solve(const AreaRegion& subject, const AreaRegion& clip, Operation operation = Operation::clip);

AreaRegion rings_of(const Polygons& polygons);

// Twice the area: main contours less their holes, by their own directions.
std::int64_t twice_area(const Polygons& polygons);

// Every contour from its least point, holes and polygons in order: equal where the polygons are.
Polygons canonical(Polygons polygons);

// Empty, or what is wrong: a contour that touches itself, runs the wrong way, a hole outside its main contour, edges
// that cross or overlap, in one list or between both.
std::string flaw(const Polygons& inside, const Polygons& outside);

}  // namespace spanline::area::test
