#include "assetc/region.hpp"

#include <cmath>

#include "assetc/input_error.hpp"

namespace spanline::host {
namespace {

constexpr std::size_t kMost = UINT16_MAX - 1;

template <typename T>
PoolRef<T> ref(std::vector<T>& blocks) {
  return {blocks.data(), static_cast<std::uint16_t>(blocks.size() - 1)};
}

// Takes what Clipper::read hands out.
struct Polygons {
  std::vector<GridPolygon> all;
  void begin_polygon() { all.emplace_back(); }
  void begin_contour() { all.back().emplace_back(); }
  void vertex(std::int32_t x, std::int32_t y) {
    all.back().back().push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)});
  }
  void end_contour() {}
  void end_polygon() {}
};

}  // namespace

std::int64_t doubled_area(const Region& region) {
  std::int64_t sum = 0;
  for (const GridRing& ring : region) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const area::GridPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      sum += std::int64_t{b.x} * a.y - std::int64_t{a.x} * b.y;
    }
  }
  return sum;
}

RegionClipper::RegionClipper(std::string place)
    : place_(std::move(place)),
      segments_(kMost + 1),
      nodes_(kMost + 1),
      edges_(std::size_t{area::kMaxEdges} + 1),
      contours_(kMost + 1),
      clipper_({ref(segments_), ref(nodes_), ref(edges_), ref(contours_)}) {}

void RegionClipper::put(const Region& subject, const Region& clip) {
  clipper_.clear();
  const auto feed = [this](area::Role role, const Region& region) {
    for (const GridRing& ring : region) {
      clipper_.begin_contour(role);
      for (const area::GridPoint& point : ring) clipper_.vertex(point.x, point.y);
      clipper_.end_contour();
    }
  };
  feed(area::Role::subject, subject);
  feed(area::Role::clip, clip);
}

void RegionClipper::demand(const Status& status) const {
  if (!status.ok()) throw InputError(place_, "the shadows on one face are too intricate");
}

Region RegionClipper::list(area::List list) const {
  Polygons polygons;
  clipper_.read(list, polygons);
  Region region;
  for (GridPolygon& polygon : polygons.all) {
    for (GridRing& ring : polygon) region.push_back(std::move(ring));
  }
  return region;
}

RegionClipper::Split RegionClipper::split(const Region& subject, const Region& clip) {
  put(subject, clip);
  demand(clipper_.clip());
  return {list(area::List::inside), list(area::List::outside)};
}

Region RegionClipper::unite(const Region& a, const Region& b) {
  put(a, b);
  demand(clipper_.unite());
  return list(area::List::inside);
}

std::vector<GridPolygon> RegionClipper::polygons(const Region& region) {
  put(region, {});
  demand(clipper_.unite());
  Polygons polygons;
  clipper_.read(area::List::inside, polygons);
  return std::move(polygons.all);
}

Region RegionClipper::without_slivers(const Region& region, std::int32_t width) {
  Region kept;
  for (GridPolygon& polygon : polygons(region)) {
    double around = 0;
    for (const GridRing& ring : polygon) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const area::GridPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        around += std::hypot(b.x - a.x, b.y - a.y);
      }
    }
    // A long strip is as wide as its area by half of its border.
    if (static_cast<double>(doubled_area(polygon)) < width * around) continue;
    for (GridRing& ring : polygon) kept.push_back(std::move(ring));
  }
  return kept;
}

}  // namespace spanline::host
