// Draws one scene and prints what that took of RAM and what its picture's bytes sum to. The first frame is the one to
// count, between the marks: its lines go to two buffers by turns, as they would with DMA, and nowhere else.
#include "boards/common/frame_marks.hpp"
#include "boards/common/report.hpp"
#include "budget.hpp"
#include "core/frame/frame.hpp"
#include "hal/mcu/semihosting.hpp"
#include "machine/stack.hpp"
#include "shown.hpp"

namespace spanline::bench {
namespace {

constexpr std::uint32_t kLineBytes = bytes_per_line(shown::kBudget.format, shown::kBudget.width);

using TheFrame = Frame<options_for(shown::kBudget)>;

// Made by the compiler where the Frame is one that it can make, else when the image starts.
FrameMemory<shown::kBudget> memory;
TheFrame frame(memory.storage());
alignas(4) std::uint8_t lines[shown::kLineBuffers][kLineBytes];
std::uint32_t sum = 2166136261u;  // FNV-1a
Status outcome;

void add_to_sum(Slice<const std::uint8_t> line) {
  for (const std::uint8_t byte : line) sum = (sum ^ byte) * 16777619u;
}

template <bool kSummed>
void draw() {
  unsigned turn = 0;
  frame_begin_mark();
  for (Band rest{0, shown::kBudget.height}; !rest.empty();) {
    const Band band = frame.prepare(shown::view, shown::camera, rest);
    if (band.empty()) break;
    while (frame.next_line(lines[turn])) {
      if constexpr (kSummed) add_to_sum(lines[turn]);
      turn = (turn + 1) % shown::kLineBuffers;
    }
    rest.top = band.bottom;
  }
  frame_end_mark();
  outcome = frame.status();
}

}  // namespace
}  // namespace spanline::bench

int main() {
  using namespace spanline;
  using namespace spanline::bench;
  const std::uint32_t stack = target::stack_used_by(draw<false>);
  draw<true>();
  boards::print_pair("memory", sizeof memory + sizeof frame);
  boards::print_pair("lines", sizeof lines);
  boards::print_pair("stack", stack);
  boards::print_pair("frame", sizeof(TheFrame));
  boards::print_pair("checksum", sum);
  boards::print("status=");
  boards::print(outcome.ok() ? "ok" : outcome.where);
  boards::print("\n");
  hal::semihosting::leave(outcome.ok() ? 0 : 1);
}
