// The engine as the host runs it: the very core, line by line into a wire-order buffer, and what taps see beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/frame/frame.hpp"
#include "sim/fifo.hpp"
#include "sim/host_memory.hpp"
#include "sim/picture.hpp"

namespace spanline::host {

// A line in wire order, as it is handed to a panel.
struct FinishedLine {
  std::uint16_t line;
  Slice<const std::uint8_t> wire;
};

// How patches are drawn.
enum class Surface : std::uint8_t { dice, points };

struct EngineOptions {
  std::uint16_t width = 320, height = 240;  // px
  PixelFormat format = PixelFormat::rgb565;
  Comparator comparator = Comparator::plane;
  Walker walker = Walker::segments;  // both: the edge walker where it can; edges: for scenes of meshes
  Surface surface = Surface::dice;   // points: scenes with layers are refused
  std::uint16_t bands = 1;           // at least that many equal ones
  PoolSizes pools;
  bool observe = false;  // face and depth of every pixel, statistics
  std::function<void(const FinishedLine&)> on_line = {};
};

// One finished frame.
struct Rendering {
  Picture picture;
  Status status;  // ok, or pool_exhausted: something was left out
  // Filled where EngineOptions::observe is set:
  std::vector<std::uint32_t> ids;    // per pixel 1 + the face's number, 0 for the background
  std::vector<std::uint16_t> depth;  // per pixel the top 16 bits of the engine's depth, 0 for the background
  Statistics statistics;
  std::vector<LineLoad> lines;
};

class Engine {
 public:
  static std::unique_ptr<Engine> make(const EngineOptions& options);
  virtual ~Engine() = default;

  // Renders a whole frame. Fails with the frame's status where nothing could be drawn.
  virtual Status render(const SceneView& scene, const CameraRecord& camera, Rendering& out) = 0;
};

}  // namespace spanline::host
