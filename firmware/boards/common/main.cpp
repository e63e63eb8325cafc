// The main of every board: shows a demo, each line computed while the one before is on its way to the panel.
#include "board.hpp"
#include "boards/common/frame_marks.hpp"
#include "boards/common/presenter.hpp"
#include "boards/common/report.hpp"
#include "boards/common/run_request.hpp"
#include "boards/common/stack.hpp"
#include "core/frame/line_frame.hpp"
#include "demos/chosen.hpp"

namespace spanline::boards {
namespace {

using BoardPanel = Board::Panel;

constexpr Screen kScreen{BoardPanel::kWidth, BoardPanel::kHeight, BoardPanel::kFormat};
constexpr demos::Demo kDemo = demos::chosen(kScreen);

constexpr Budget budget() {
  Budget fitted = Board::fit(demos::budget_for(kDemo, kScreen));
  fitted.scan_out = policy_on<BoardPanel>(fitted.scan_out);
  if (fitted.scan_out == ScanPolicy::full) fitted.kept_instances = 0;  // a panel with pages takes every line
  return fitted;
}
constexpr Budget kBudget = budget();
constexpr std::uint32_t kLineBytes = bytes_per_line(kScreen.format, kScreen.width);
static_assert(hal::Panel<BoardPanel>);

class LinePair {
 public:
  Slice<std::uint8_t> back() { return lines_[turn_]; }
  void swap() { turn_ ^= 1; }

 private:
  alignas(4) std::uint8_t lines_[2][kLineBytes]{};
  unsigned turn_ = 0;
};

using TheFrame = FrameFor<kBudget>;

MemoryFor<kBudget> memory;
ScanOutMemory<kBudget> shown_before;
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

ScanOutStorage scan_out_storage() {
  ScanOutStorage storage = shown_before.storage();
  storage.window_bytes = window_bytes_of<BoardPanel>();
  return storage;
}

// A function of its own whatever the frame: by it the simulator tells the lines apart (host_sim/mcu/marks.hpp).
[[gnu::noinline]] bool next_line(TheFrame& frame) { return frame.next_line(lines.back()); }

void draw(TheFrame& frame, Presenter<BoardPanel>& presenter) {
  presenter.begin_frame(stage.view().scene().background);
  frame.redraw(presenter.stale());
  for (Band rest{0, kScreen.height}; !rest.empty();) {
    const Band band = frame.prepare(stage.view(), stage.camera(), rest);
    if (band.empty()) break;
    for (std::uint16_t line = band.top; next_line(frame); ++line) {
      bool in_flight;
      demand(presenter.line(line, {lines.back().data(), kLineBytes}, in_flight), line);
      if (in_flight) lines.swap();
    }
    rest.top = band.bottom;
  }
  demand(presenter.end_frame(), kScreen.height);
  demand(frame.status());
}

void report(std::uint32_t shown) {
  print("shown frame=");
  print(shown);
  print(" stack=");
  print(stack_used());
  print("\n");
}

// Apart, so that the pools' table does not stay on the stack.
[[gnu::noinline]] TheFrame make_frame() { return TheFrame(memory.storage()); }

[[noreturn]] void run() {
  demand(board.begin());
  BoardPanel& panel = board.panel();
  demand(panel.begin());
  demand(stage.begin(kDemo, kScreen));
  TheFrame frame = make_frame();
  Presenter<BoardPanel> presenter(panel, scan_out_storage());
  for (std::uint32_t shown = 0;; ++shown) {
    frame_begin_mark();
    stage.show(shown);
    draw(frame, presenter);
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
