// Before there is hardware: one scene on many displays, with larger and smaller pools, on faster and slower parts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assetc/scene_description.hpp"
#include "core/frame/budget.hpp"

namespace spanline::host {

// What a frame consists of.
struct FrameWork {
  double pixels = 0;
  double faces = 0;        // of the scene
  double crossings = 0;    // of edges and lines, an edge's of each face: seed 1's N
  double overlaps = 0;     // depth tests, more than one for each face and line
  double references = 0;   // of segment blocks, seed 1's M
  double faces_again = 0;  // faces looked at once more for every band after the first
};

// What a frame costs a core, in cycles of each part of its work: an estimate, good to about a third (docs/budget.md).
struct FramePrice {
  const char* core;
  Walker walker;  // segments or edges
  bool gouraud;
  FrameWork cycles;
};
const std::vector<FramePrice>& frame_prices();
const FramePrice& price_of(const std::string& core, Walker walker, bool gouraud);
double estimated_cycles(const FramePrice& price, const FrameWork& work);

// The cores that have prices.
inline constexpr const char* kPricedCores[] = {"m0+", "m3", "m4"};

struct SweepRow {
  spanline::Budget budget;  // pools of this row, at the display's size, of one walker
  unsigned percent = 100;   // of the fitted pools
  std::uint32_t bytes = 0;  // pools and two lines
  std::uint32_t bands = 0;  // most of a frame; 0: some line has no room, something would be left out
  FrameWork work;           // the most of each in a frame
  // Core cycles of a frame.
  double cycles_on(const std::string& core) const {
    return estimated_cycles(price_of(core, budget.walker, budget.gouraud), work);
  }
};

struct Sweep {
  std::vector<SweepRow> rows;
  spanline::Budget suggested;  // at the scene's own size, with margins; for the edge walker where it can draw the scene
  unsigned margin_percent;
};

// Throws InputError where the scene cannot be drawn.
Sweep sweep(const SceneDescription& scene);

std::string sweep_text(const Sweep& sweep);
std::string sweep_json(const Sweep& sweep);

}  // namespace spanline::host
