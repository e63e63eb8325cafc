// Before there is hardware: one scene on many displays, with larger and smaller pools, on faster and slower parts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assetc/scene_description.hpp"
#include "core/frame/budget.hpp"

namespace spanline::host {

// What a frame costs a core: an estimate by what is counted in it, good to about a third (docs/budget.md).
struct FramePrice {
  const char* core;
  double reference, pixel, face_again;  // cycles each
};
const std::vector<FramePrice>& frame_prices();

// What a frame consists of.
struct FrameWork {
  std::uint64_t references = 0;  // of segment blocks, seed 1's M
  std::uint64_t pixels = 0;
  std::uint64_t faces_again = 0;  // faces looked at once more for every band after the first
};
double estimated_cycles(const FramePrice& price, const FrameWork& work);

struct SweepRow {
  spanline::Budget budget;  // pools of this row, at the display's size
  unsigned percent = 100;   // of the fitted pools
  std::uint32_t bytes = 0;  // pools and two lines
  std::uint32_t bands = 0;  // most of a frame; 0: some line has no room, something would be left out
  FrameWork work;           // the most of each in a frame
};

struct Sweep {
  std::vector<SweepRow> rows;
  spanline::Budget suggested;  // at the scene's own size, with margins
  unsigned margin_percent;
};

// Throws InputError where the scene cannot be drawn.
Sweep sweep(const SceneDescription& scene);

std::string sweep_text(const Sweep& sweep);
std::string sweep_json(const Sweep& sweep);

}  // namespace spanline::host
