// A scene on the terminal: the engine makes grey lines, the callback prints them as characters. On a board the callback
// would start a DMA transfer instead; nothing else changes.
#include <cstdio>

#include "core/frame/frame.hpp"
#include "nut.hpp"

namespace {

constexpr spanline::Budget kBudget{
    .width = nut::kWidth, .height = nut::kHeight, .format = spanline::PixelFormat::grey8, .facets = 64, .vertices = 64};

spanline::FrameMemory<kBudget> memory;  // all that the engine ever needs: no heap, no frame buffer
alignas(4) std::uint8_t line[spanline::bytes_per_line(kBudget.format, kBudget.width)];

void show_line(unsigned y) {
  if (y % 2 != 0) return;  // a character is twice as high as it is wide
  constexpr char kShades[] = " .:-=+*#%@";
  for (const std::uint8_t grey : line) std::putchar(kShades[grey * 10 / 256]);
  std::putchar('\n');
}

}  // namespace

int main() {
  spanline::SceneView view;
  spanline::Status status = spanline::SceneView::validate(nut::scene, view);
  spanline::Frame<> frame(memory.storage());
  for (spanline::Band rest{0, nut::kHeight}; status.ok() && !rest.empty();) {
    const spanline::Band band = frame.prepare(view, nut::camera, rest);
    for (unsigned y = band.top; frame.next_line(line); ++y) show_line(y);
    status = frame.status();
    rest.top = band.bottom;
  }
  if (!status.ok())
    std::fprintf(stderr, "%s %u: %s\n", status.where, static_cast<unsigned>(status.index), status.field);
  return status.ok() ? 0 : 1;
}
