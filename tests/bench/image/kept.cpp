// Draws one scene four times, each frame between the marks, as a frame does that knows the one before: whole; whole
// again, though nothing has moved; eight lines in the middle; and nothing, as nothing has changed.
#include "boards/common/frame_marks.hpp"
#include "budget.hpp"
#include "core/frame/frame.hpp"
#include "hal/mcu/semihosting.hpp"
#include "shown.hpp"

namespace spanline::bench {
namespace {

constexpr Budget kBudget = [] {
  Budget budget = shown::kBudget;
  budget.kept_instances = 4;
  return budget;
}();

using TheFrame = Frame<options_for(kBudget)>;

FrameMemory<kBudget> memory;
alignas(4) std::uint8_t lines[2][bytes_per_line(kBudget.format, kBudget.width)];

void draw(TheFrame& frame) {
  unsigned turn = 0;
  frame_begin_mark();
  for (Band rest{0, kBudget.height}; !rest.empty();) {
    const Band band = frame.prepare(shown::view, shown::camera, rest);
    if (band.empty()) break;
    while (frame.next_line(lines[turn])) turn ^= 1;
    rest.top = band.bottom;
  }
  frame_end_mark();
}

}  // namespace
}  // namespace spanline::bench

int main() {
  using namespace spanline;
  using namespace spanline::bench;
  TheFrame frame(memory.storage());
  draw(frame);
  frame.redraw({0, kBudget.height});
  draw(frame);
  constexpr std::uint16_t kMiddle = kBudget.height / 2;
  frame.redraw({kMiddle, kMiddle + 8});
  draw(frame);
  draw(frame);
  hal::semihosting::leave(frame.status().ok() ? 0 : 1);
}
