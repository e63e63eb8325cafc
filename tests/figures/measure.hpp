// The ten objects through the engine, counted.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "seed.hpp"

namespace spanline::figures {

inline constexpr std::uint16_t kRaster = 512;  // px, both ways

// What is built: the seed's last machine, the one before it (bucket sort), and the last with VSG4's plane comparator.
enum class Machine : std::uint8_t { vsg6, vsg5, plane };

struct Measured {
  nlohmann::json rows;                  // by the names of --stats; polygons and edges of the whole object
  std::uint32_t active_references = 0;  // entries of the active list looked at again in a later span
  std::vector<std::uint32_t> ids;       // per pixel 1 + the face's number, 0 for the background

  double row(const char* key) const { return rows.at(key).get<double>(); }
  // R if a second look through the active list were a reference too.
  double ratio_with_active() const { return (row("segment_references") + active_references) / row("edge_crossings"); }
};

// Renders one object of `folder`. Throws InputError where a file cannot be read or something was left out of the
// picture.
Measured measure(const std::string& folder, const Object& object, Machine machine);

// One object through all three.
struct ObjectFigures {
  Measured vsg6, vsg5, plane;
};
std::vector<ObjectFigures> measure_all(const std::string& folder);

}  // namespace spanline::figures
