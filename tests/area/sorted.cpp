#include "area/sorted.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace spanline::area::test {

double distance(AreaPoint at, AreaPoint a, AreaPoint b) {
  const double x = static_cast<double>(at.x - a.x), y = static_cast<double>(at.y - a.y);
  const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
  const double t = std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - t * dx, y - t * dy);
}

VisiblePieces read(const AreaSort& sort) {
  VisiblePieces pieces;
  Reading reading{&pieces};
  sort.read(reading);
  return pieces;
}

void put(AreaSort& sort, const oracle::SortPolygon& polygon, Opacity opacity) {
  sort.begin_polygon(polygon.source, opacity);
  for (const AreaRing& ring : polygon.region) {
    sort.begin_contour();
    for (const AreaPoint p : ring) {
      sort.vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y),
                  static_cast<std::int32_t>(polygon.value(p) >> kPlaneBits));
    }
    sort.end_contour();
  }
  sort.end_polygon();
}

Sorted sort(const oracle::SortScene& scene, const std::vector<std::uint16_t>& translucent) {
  static const auto storage = std::make_unique<SortStorage<2000, 30000, 8000, 4000>>();
  AreaSort sort(storage->refs());
  sort.clear();
  for (const oracle::SortPolygon& polygon : scene) {
    const bool clear = std::find(translucent.begin(), translucent.end(), polygon.source) != translucent.end();
    put(sort, polygon, clear ? Opacity::translucent : Opacity::opaque);
  }
  Sorted sorted;
  sorted.status = sort.solve();
  sorted.counts = sort.counts();
  sorted.pieces = read(sort);
  return sorted;
}

AreaRegion rings_of(const VisiblePieces& pieces) {
  AreaRegion region;
  for (const VisiblePiece& piece : pieces) region.insert(region.end(), piece.rings.begin(), piece.rings.end());
  return region;
}

// Overlaps would cancel in the even-odd union.
std::string flaw(const VisiblePieces& pieces) {
  std::int64_t sum = 0;
  for (const VisiblePiece& piece : pieces) {
    if (std::string text = flaw(Polygons{piece.polygon}, {}); !text.empty()) return text;
    sum += twice_area(Polygons{piece.polygon});
  }
  const Solved all = solve(rings_of(pieces), {}, Operation::unite);
  if (!all.status.ok()) return std::string("the union's pool is too small: ") + all.status.where;
  if (all.counts.rounded != 0) return "edges cross off the grid";
  if (twice_area(all.inside) != sum) return "pieces overlap";
  return "";
}

int seen_at(const VisiblePieces& pieces, AreaPoint p, double reach, bool& doubtful) {
  int seen = -1;
  for (const VisiblePiece& piece : pieces) {
    for (const AreaRing& ring : reach > 0 ? piece.rings : AreaRegion{}) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        if (distance(p, ring[i], ring[(i + 1) % ring.size()]) <= reach) doubtful = true;
      }
    }
    bool on_border = false;
    if (oracle::covers(piece.rings, {2 * p.x, 2 * p.y}, on_border)) seen = piece.source;
  }
  return seen;
}

}  // namespace spanline::area::test
