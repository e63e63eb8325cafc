#include "clip/clip_regions.hpp"

#include <algorithm>
#include <cmath>

#include "assetc/input_error.hpp"
#include "core/area/clipper.hpp"

namespace spanline::host {
namespace {

using nlohmann::json;

// Pools as large as 16-bit indices allow, less where the input cannot need as much.
class HeapPools {
 public:
  explicit HeapPools(std::size_t points) : segments_(std::min<std::size_t>(points, kMost) + 1) {}

  area::Pools refs() { return {ref(segments_), ref(nodes_), ref(edges_), ref(contours_)}; }

 private:
  static constexpr std::size_t kMost = UINT16_MAX - 1;

  template <typename T>
  static PoolRef<T> ref(std::vector<T>& blocks) {
    return {blocks.data(), static_cast<std::uint16_t>(blocks.size() - 1)};
  }

  std::vector<area::Segment> segments_;
  std::vector<area::Node> nodes_{kMost + 1};
  std::vector<area::Edge> edges_{std::size_t{area::kMaxEdges} + 1};
  std::vector<area::Contour> contours_{kMost + 1};
};

std::size_t points_of(const GeoRegion& region) {
  std::size_t count = 0;
  for (const GeoRing& ring : region.rings) count += ring.size();
  return count;
}

WorkingGrid grid_for(const GeoRegion& subject, const GeoRegion& clip) {
  std::vector<WorkingGrid::Point> points;
  for (const GeoRegion* region : {&subject, &clip}) {
    for (const GeoRing& ring : region->rings) points.insert(points.end(), ring.begin(), ring.end());
  }
  return WorkingGrid::holding(points);
}

void put(area::Clipper& clipper, area::Role role, const GeoRegion& region, const WorkingGrid& grid) {
  for (const GeoRing& ring : region.rings) {
    clipper.begin_contour(role);
    for (const WorkingGrid::Point& point : ring) {
      const WorkingGrid::Cell cell = grid.to_grid(point);
      clipper.vertex(cell.x, cell.y);
    }
    clipper.end_contour();
  }
}

// Whole values without a point, as they came.
json number(double value) {
  if (value == std::floor(value)) return static_cast<std::int64_t>(value);
  return value;
}

// A list of the clipper as the coordinates of a MultiPolygon: the core's direction reversed, rings closed.
class Coordinates {
 public:
  explicit Coordinates(const WorkingGrid& grid) : grid_(grid) {}

  void begin_polygon() { polygons_.push_back(json::array()); }
  void begin_contour() { ring_.clear(); }
  void vertex(std::int32_t x, std::int32_t y) {
    ring_.push_back(json::array({number(grid_.x_of(x)), number(grid_.y_of(y))}));
  }
  void end_contour() {
    std::reverse(ring_.begin() + 1, ring_.end());
    ring_.push_back(ring_.front());
    polygons_.back().push_back(ring_);
  }
  void end_polygon() {}

  json take() { return std::move(polygons_); }

 private:
  const WorkingGrid& grid_;
  json polygons_ = json::array();
  std::vector<json> ring_;
};

json feature(const area::Clipper& clipper, area::List list, const char* name, const WorkingGrid& grid) {
  Coordinates coordinates(grid);
  clipper.read(list, coordinates);
  return {{"type", "Feature"},
          {"properties", {{"list", name}, {"scale", number(grid.scale())}}},
          {"geometry", {{"type", "MultiPolygon"}, {"coordinates", coordinates.take()}}}};
}

}  // namespace

ClippedRegions clip_regions(const GeoRegion& subject, const GeoRegion& clip) {
  const WorkingGrid grid = grid_for(subject, clip);
  HeapPools pools(points_of(subject) + points_of(clip));
  area::Clipper clipper(pools.refs());
  clipper.clear();
  put(clipper, area::Role::subject, subject, grid);
  put(clipper, area::Role::clip, clip, grid);
  if (const Status status = clipper.clip(); !status.ok()) {
    const GeoRegion& blamed = status.field == std::string("clip") ? clip : subject;
    throw InputError(blamed.file, std::string("is too intricate: the clipper has room for ") +
                                      std::to_string(status.limit) + " " + status.where + ", and more are needed");
  }
  json features = json::array(
      {feature(clipper, area::List::inside, "inside", grid), feature(clipper, area::List::outside, "outside", grid)});
  return {{{"type", "FeatureCollection"}, {"features", std::move(features)}},
          clipper.counts().dropped_contours,
          clipper.counts().merged_points};
}

}  // namespace spanline::host
