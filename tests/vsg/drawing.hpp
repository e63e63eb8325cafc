// Drives the engine over one frame and records what it decided, for every choice that must not change the picture.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/frame/frame.hpp"
#include "oracle/picture.hpp"

namespace spanline::test {

// Blocks that each pool may use; the default is all of them.
struct PoolLimits {
  std::uint32_t facets = 65535, vertices = 65535, polygons = 65535, edges = 65535, segments = 65535, active = 65535,
                samples = 65535, implied = 65535, layers = 65535;
};

// What a frame's caller may choose freely.
struct Choices {
  Comparator comparator = Comparator::plane;
  PoolLimits limits;
  std::vector<std::uint16_t> cuts;  // lines, rising, where a new band is asked for
  XSort x_sort = XSort::list;
  bool layers = false;  // VsgOptions::layers; with XSort::list
};

// Depth that the engine held for a visible pixel, as a fraction of 2^13 --screen units (Q16.13).
using EngineDepth = std::int32_t;

struct Drawing {
  explicit Drawing(const Screen& screen);

  oracle::Picture faces;                           // the nearest ones
  std::vector<std::vector<std::uint32_t>> stacks;  // all that are seen, the nearest first; where Choices::layers
  std::vector<EngineDepth> depths;                 // row by row, 0 at the background
  std::vector<std::uint8_t> bytes;                 // all lines in wire order
  Status status;
  std::uint32_t bands = 0;
  Statistics statistics;
  std::string broken;  // what was wrong with the stream of spans itself (gaps, overlaps, missing lines); empty: nothing
};

// The picture that the random scenes are made for, and pools that hold every one of them whole.
inline constexpr Budget kRandomBudget{.width = 64,
                                      .height = 48,
                                      .facets = 128,
                                      .vertices = 2048,
                                      .polygons = 96,
                                      .edges = 2200,
                                      .segments = 1024,
                                      .samples = 512,
                                      .implied = 512,
                                      .layers = 512};
inline constexpr Screen kRandomScreen{kRandomBudget.width, kRandomBudget.height, kRandomBudget.format};

// Owns the frame's memory, which goes from drawing to drawing as it was left: nothing may depend on it.
class Drawer {
 public:
  Drawer();
  Drawing draw(const SceneView& scene, const CameraRecord& camera, const Choices& choices);

 private:
  std::unique_ptr<FrameMemory<kRandomBudget>> memory_;
};

}  // namespace spanline::test
