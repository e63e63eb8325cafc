// The frame loop that is measured, the same on the target and on the host.
#pragma once

#include "boards/common/frame_marks.hpp"
#include "core/frame/frame.hpp"

namespace spanline::target {

struct Picture {
  std::uint32_t checksum = 2166136261u;  // FNV-1a over the bytes of all lines
  std::uint32_t bands = 0;
  Status status;

  void add(Slice<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) checksum = (checksum ^ byte) * 16777619u;
  }
};

// The memory that a program with `kBudget` needs besides its stack. The two line buffers take turns, as they would with
// DMA.
template <Budget kBudget>
struct Program {
  static constexpr std::uint32_t kLineBytes = bytes_per_line(kBudget.format, kBudget.width);
  static inline FrameMemory<kBudget> memory;
  alignas(4) static inline std::uint8_t lines[2][kLineBytes];
  static inline Picture picture;

  // Apart, so that the pools' table does not stay on the stack.
  [[gnu::noinline]] static Frame<> make_frame() { return Frame<>(memory.storage()); }

  static void draw(const SceneRecord& scene, const CameraRecord& camera) {
    picture = {};
    SceneView view;
    picture.status = SceneView::validate(scene, view);
    if (!picture.status.ok()) return;
    Frame<> frame = make_frame();
    unsigned turn = 0;
    frame_begin_mark();
    for (Band rest{0, kBudget.height}; !rest.empty();) {
      const Band band = frame.prepare(view, camera, rest);
      if (band.empty()) break;
      ++picture.bands;
      while (frame.next_line(lines[turn])) {
        picture.add(lines[turn]);
        turn ^= 1;
      }
      rest.top = band.bottom;
    }
    frame_end_mark();
    picture.status = frame.status();
  }
};

}  // namespace spanline::target
