// A firmware's use of the engine, for tests/house/freestanding.sh: what one picture costs in code and memory, linked.
#include "core/frame/frame.hpp"

namespace {

constexpr spanline::Budget kBudget;
spanline::FrameMemory<kBudget> memory;
alignas(4) std::uint8_t line[spanline::bytes_per_line(kBudget.format, kBudget.width)];

}  // namespace

extern "C" bool draw_frame(const spanline::SceneRecord& scene, const spanline::CameraRecord& camera,
                           void (*send)(const std::uint8_t* bytes, std::uint32_t count)) {
  spanline::SceneView view;
  if (!spanline::SceneView::validate(scene, view).ok()) return false;
  spanline::Frame<> frame(memory.storage());
  for (spanline::Band rest{0, kBudget.height}; !rest.empty();) {
    const spanline::Band band = frame.prepare(view, camera, rest);
    if (band.empty()) return false;
    while (frame.next_line(line)) send(line, sizeof line);
    rest.top = band.bottom;
  }
  return frame.status().ok();
}
