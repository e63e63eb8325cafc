// Runs an image as its board would: every instruction, from reset to where it stops.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mcu/board.hpp"
#include "mcu/call_tree.hpp"
#include "mcu/count.hpp"
#include "mcu/frame_recorder.hpp"
#include "mcu/image.hpp"
#include "mcu/places.hpp"
#include "mcu/pool_watch.hpp"
#include "sim/picture.hpp"

namespace spanline::host {

// Functions that our images pass before and after each frame.
inline constexpr const char* kFrameBeginMark = "frame_begin_mark";
inline constexpr const char* kFrameEndMark = "frame_end_mark";

struct RunOptions {
  std::string from;       // symbol where counting begins, empty: at reset
  std::string until;      // symbol where counting ends, before its first instruction; empty: where the image stops
  unsigned passages = 1;  // from `from` to `until` so often, then the run ends
  std::uint64_t limit = 4'000'000'000;                         // instructions, then the run is given up
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;  // address, value: written into RAM before the reset
  bool as_emulator =
      false;  // time as QEMU's -icount shift=0: a nanosecond an instruction, nothing on the wire; no cycles
  bool step_by_step = false;  // loops that wait are not replayed (wait_turns.hpp): slower, and all counts are the same
};

// The panel at the end of the run.
struct PanelReport {
  Picture picture;
  std::vector<std::string> complaints;  // what went against the panel's protocol or the chip's limits
  std::uint32_t wire_hz = 0;
  std::uint64_t bytes = 0, dma_bytes = 0;  // of the whole run
};

struct RunReport {
  std::string end;               // why it ended: "exit 0", "reached frame_end_mark", "BKPT in main", …
  std::uint32_t exit_code = 0;   // of the image
  std::string output;            // what it said by semihosting
  bool timed = false;            // cycles were counted, not instructions only
  Count total;                   // of what was counted
  std::vector<Count> passages;   // each from `from` to `until`
  std::vector<Count> functions;  // in the order of Image::functions(), then what belongs to none
  std::uint32_t initial_sp = 0;
  std::uint32_t stack_reached = 0;      // bytes below initial_sp, of the whole run
  std::string stack_deepest;            // the function that reached it
  std::vector<std::string> stack_path;  // and who called it, outermost first
  std::vector<std::string> executed;    // functions of which the run executed anything
  std::optional<PanelReport> panel;     // where the board has one
  std::vector<FrameRecord> frames;      // of images whose frames are marked
  CallTree calls;                       // of what was counted
  std::vector<PoolUse> pools;           // of the image's FrameMemory, where its debug information tells of one
  std::vector<Places::Frame> places;    // the frames of `calls`
  std::uint64_t unknown = 0;            // instructions that the decoder has no name for, taken as one cycle each
};

// Throws InputError where the image does not fit the board, faults (with the registers and the function's name),
// touches what is not modelled, runs past the limit, or does not pass `until`.
RunReport run_image(const Image& image, const BoardDescription& board, const RunOptions& options);

inline constexpr std::uint32_t kSecondStageBoot = 256;  // bytes

struct StartState {
  std::uint32_t sp, pc;  // pc without its Thumb bit
  std::uint32_t vectors;
  bool has_vectors;            // else started at the ELF's entry point
  std::uint32_t boots_by = 0;  // where the second-stage boot lies that comes first, 0: there is none
};

// From the vector table at the image's beginning (behind a second-stage boot of 256 bytes, too).
StartState start_of(const Image& image, const BoardDescription& board);

}  // namespace spanline::host
