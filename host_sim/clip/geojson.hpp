// Regions as GeoJSON (RFC 7946).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "clip/working_grid.hpp"

namespace spanline::host {

using GeoRing = std::vector<WorkingGrid::Point>;  // not closed

// An even-odd region: the rings of all polygons.
struct GeoRegion {
  std::string file;
  std::vector<GeoRing> rings;
};

// A Polygon, a MultiPolygon or a Feature with one; members that are not needed, and third coordinates, are passed over.
// Throws InputError with file and JSON path; whole coordinates must be within ±32767 unless the file has decimals too.
GeoRegion read_geojson(const std::string& path);

}  // namespace spanline::host
