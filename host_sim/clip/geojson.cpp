#include "clip/geojson.hpp"

#include <cmath>
#include <optional>

#include "assetc/json_node.hpp"
#include "assetc/text_file.hpp"
#include "core/area/predicates.hpp"

namespace spanline::host {
namespace {

class Reader {
 public:
  explicit Reader(GeoRegion& region) : region_(region) {}

  void geometry(const JsonNode& node, bool within_feature) {
    if (!node.is_object()) node.fail("must be an object");
    const JsonNode type = node.require("type");
    const std::string name = type.text();
    if (name == "Feature" && !within_feature) return geometry(node.require("geometry"), true);
    if (name != "Polygon" && name != "MultiPolygon") {
      type.fail(within_feature ? "must be Polygon or MultiPolygon, not '" + printable(name) + "'"
                               : "must be Polygon, MultiPolygon or a Feature with one, not '" + printable(name) + "'");
    }
    const JsonNode coordinates = node.require("coordinates");
    if (name == "Polygon") return polygon(coordinates);
    for (const JsonNode& each : coordinates.elements()) polygon(each);
  }

  // Whole numbers stand for themselves, so one that the grid does not reach is an error; decimals are scaled.
  void check_range() const {
    if (too_far_ && !decimals_) {
      too_far_->fail("must be a whole number from -" + std::to_string(area::kMaxCoordinate) + " to " +
                     std::to_string(area::kMaxCoordinate) + ": only files with decimals are scaled");
    }
  }

 private:
  void polygon(const JsonNode& node) {
    for (const JsonNode& each : node.elements()) ring(each);
  }

  void ring(const JsonNode& node) {
    GeoRing points;
    for (const JsonNode& position : node.elements()) {
      const std::vector<JsonNode> parts = position.elements(2);
      points.push_back({coordinate(parts[0]), coordinate(parts[1])});
    }
    const bool closed = points.size() > 1 && points.front().x == points.back().x && points.front().y == points.back().y;
    if (closed) points.pop_back();
    if (!points.empty()) region_.rings.push_back(std::move(points));
  }

  double coordinate(const JsonNode& node) {
    const double value = node.number(-kMaxCoordinate, kMaxCoordinate);
    if (value != std::floor(value)) decimals_ = true;
    if (!too_far_ && std::fabs(value) > area::kMaxCoordinate) too_far_ = node;
    return value;
  }

  GeoRegion& region_;
  bool decimals_ = false;
  std::optional<JsonNode> too_far_;
};

}  // namespace

GeoRegion read_geojson(const std::string& path) {
  const nlohmann::json document = parse_json(path, read_file(path));
  GeoRegion region{path, {}};
  Reader reader(region);
  reader.geometry({document, path}, false);
  reader.check_range();
  return region;
}

}  // namespace spanline::host
