// The clipper on GeoJSON regions.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>

#include "clip/geojson.hpp"

namespace spanline::host {

struct ClippedRegions {
  nlohmann::json collection;           // a FeatureCollection of the inside and the outside list
  std::uint32_t dropped_contours = 0;  // rings without area
  std::uint32_t merged_points = 0;     // points equal to their forerunner
};

// Throws InputError where a region is larger than the clipper's indices reach.
ClippedRegions clip_regions(const GeoRegion& subject, const GeoRegion& clip);

}  // namespace spanline::host
