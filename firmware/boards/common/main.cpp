// The main of every board: shows a demo, each line computed while the one before is on its way to the panel.
#include "board.hpp"
#include "boards/common/frame_marks.hpp"
#include "boards/common/report.hpp"
#include "boards/common/run_request.hpp"
#include "boards/common/stack.hpp"
#include "core/frame/frame.hpp"
#include "demos/chosen.hpp"

namespace spanline::boards {
namespace {

using BoardPanel = Board::Panel;

constexpr Screen kScreen{BoardPanel::kWidth, BoardPanel::kHeight, BoardPanel::kFormat};
constexpr demos::Demo kDemo = demos::chosen(kScreen);
constexpr Budget kBudget = Board::fit(demos::budget_for(kDemo, kScreen));
constexpr std::uint32_t kLineBytes = bytes_per_line(kScreen.format, kScreen.width);
static_assert(hal::Panel<BoardPanel>);

class LinePair {
 public:
  Slice<std::uint8_t> back() { return lines_[turn_]; }
  // Swaps, and returns what was the back.
  Slice<const std::uint8_t> swap() {
    const std::uint8_t(&finished)[kLineBytes] = lines_[turn_];
    turn_ ^= 1;
    return finished;
  }

 private:
  alignas(4) std::uint8_t lines_[2][kLineBytes]{};
  unsigned turn_ = 0;
};

FrameMemory<kBudget> memory;
constinit LinePair lines;
constinit demos::Stage stage;
constinit Board board;

// Ends the run where `fault` is one; the status register of the report is the line.
void demand(hal::Fault fault, std::uint32_t line = 0) {
  if (fault != hal::Fault::none) stop(hal::name(fault), static_cast<std::uint32_t>(fault), line, 0);
}

void demand(const Status& status) {
  constexpr std::uint32_t kAfterTheFaults = 8;
  if (!status.ok()) stop(status.where, kAfterTheFaults + static_cast<std::uint32_t>(status.code), status.line, 0);
}

void draw(Frame<>& frame, BoardPanel& panel) {
  demand(panel.open({0, 0, kScreen.width, kScreen.height}));
  for (Band rest{0, kScreen.height}; !rest.empty();) {
    const Band band = frame.prepare(stage.view(), stage.camera(), rest);
    if (band.empty()) return demand(frame.status());
    for (std::uint16_t line = band.top; frame.next_line(lines.back()); ++line) {
      demand(panel.send(lines.swap()), line);
    }
    rest.top = band.bottom;
  }
  demand(panel.wait(), kScreen.height);
  demand(frame.status());
}

void report(std::uint32_t shown) {
  print("shown frame=");
  print(shown);
  print(" stack=");
  print(stack_used());
  print("\n");
}

[[noreturn]] void run() {
  demand(board.begin());
  BoardPanel& panel = board.panel();
  demand(panel.begin());
  demand(stage.begin(kDemo, kScreen));
  Frame<> frame(memory.storage());
  for (std::uint32_t shown = 0;; ++shown) {
    frame_begin_mark();
    stage.show(shown);
    draw(frame, panel);
    frame_end_mark();
    if (request().made() && shown == request().last_frame) {
      report(shown);
      board.rest();
    }
  }
}

}  // namespace

void light(bool on) { Board::light(on); }

}  // namespace spanline::boards

// SysTick's vector: once a millisecond, on boards that start it.
extern "C" void tick() { spanline::boards::Board::tick(); }

int main() { spanline::boards::run(); }
