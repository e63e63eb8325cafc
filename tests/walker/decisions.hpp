// What the walkers decide of random mesh scenes, pixel by pixel.
#pragma once

#include <algorithm>

#include "core/frame/frame_impl.hpp"
#include "sim/host_memory.hpp"
#include "walker/random_mesh_scene.hpp"

namespace spanline::test {

// What a frame decided.
struct Decisions {
  explicit Decisions(const Screen& screen)
      : width(screen.width), faces(std::size_t{screen.width} * screen.height, 1), depths(faces.size(), 1) {}
  std::size_t width;
  std::vector<std::uint16_t> faces;
  std::vector<std::uint32_t> depths;
  std::vector<std::uint8_t> bytes;
  Status status;
  bool drawn = true;
};

inline void record_span(void* context, const VisibleSpan& span) {
  auto& decisions = *static_cast<Decisions*>(context);
  for (std::size_t column = span.left; column < span.right; ++column) {
    const std::size_t pixel = span.line * decisions.width + column;
    decisions.faces.at(pixel) = span.face;
    decisions.depths.at(pixel) = span.face == kNoFace ? 0 : span.depth.at(static_cast<std::int32_t>(column));
  }
}

// Without taps only the bytes and the status.
template <FrameOptions kOptions>
Decisions draw_by(const FrameStorage& storage, const SceneView& view, const CameraRecord& camera,
                  std::uint16_t first_band = 2046) {
  Decisions decisions(storage.screen);
  Frame<kOptions> frame(storage);
  if constexpr (kOptions.taps) frame.set_tap({&decisions, record_span});
  std::vector<std::uint32_t> words(frame.line_bytes() / 4 + 1);
  const Slice<std::uint8_t> line(reinterpret_cast<std::uint8_t*>(words.data()), frame.line_bytes());
  for (Band rest{0, storage.screen.height}; !rest.empty();) {
    const Band wanted{rest.top, rest.top == 0 ? std::min(first_band, rest.bottom) : rest.bottom};
    const Band band = frame.prepare(view, camera, wanted);
    if (band.empty()) {
      decisions.drawn = false;
      break;
    }
    while (frame.next_line(line)) decisions.bytes.insert(decisions.bytes.end(), line.begin(), line.end());
    rest.top = band.bottom;
  }
  decisions.status = frame.status();
  return decisions;
}
template <Walker kWalker>
Decisions draw(const FrameStorage& storage, const SceneView& view, const CameraRecord& camera,
               std::uint16_t first_band = 2046) {
  return draw_by<FrameOptions{.taps = true, .walker = kWalker}>(storage, view, camera, first_band);
}

// Pools that hold any of the random scenes; the edges can be too few.
struct Memory {
  explicit Memory(const Screen& screen, std::uint16_t edges = 2000, bool gouraud = true)
      : memory(screen, screen.height,
               {.facets = 4000,
                .vertices = 4000,
                .polygons = 2000,
                .edges = edges,
                .segments = 2000,
                .samples = 500,
                .implied = 100,
                .gouraud = gouraud}) {}
  host::HostMemory memory;
};

}  // namespace spanline::test
