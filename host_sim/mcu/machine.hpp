// Runs an image as its board would: every instruction, from reset to where it stops.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mcu/board.hpp"
#include "mcu/image.hpp"

namespace spanline::host {

struct Count {
  std::uint64_t instructions = 0;
  std::uint64_t cycles = 0;  // core cycles, zero wait states; 0 on cores without a model

  Count& operator+=(const Count& other);
  Count operator-(const Count& other) const;
};

struct RunOptions {
  std::string from;       // symbol where counting begins, empty: at reset
  std::string until;      // symbol where counting ends, before its first instruction; empty: where the image stops
  unsigned passages = 1;  // from `from` to `until` so often, then the run ends
  std::uint64_t limit = 4'000'000'000;                         // instructions, then the run is given up
  std::vector<std::pair<std::uint32_t, std::uint32_t>> words;  // address, value: written into RAM before the reset
};

struct RunReport {
  std::string end;               // why it ended: "exit 0", "reached frame_end_mark", "BKPT in main", …
  std::uint32_t exit_code = 0;   // of the image
  std::string output;            // what it said by semihosting
  Count total;                   // of what was counted
  std::vector<Count> passages;   // each from `from` to `until`
  std::vector<Count> functions;  // in the order of Image::functions(), then what belongs to none
  std::uint32_t initial_sp = 0;
  std::uint32_t stack_reached = 0;  // bytes below initial_sp, of the whole run
  std::string stack_deepest;        // the function that reached it
  std::uint64_t unknown = 0;        // instructions that the decoder has no name for, taken as one cycle each
};

// Throws InputError where the image does not fit the board, faults (with the registers and the function's name),
// touches what is not modelled, runs past the limit, or does not pass `until`.
RunReport run_image(const Image& image, const BoardDescription& board, const RunOptions& options);

struct StartState {
  std::uint32_t sp, pc;  // pc without its Thumb bit
  std::uint32_t vectors;
  bool has_vectors;  // else started at the ELF's entry point
};

// From the vector table at the image's beginning (behind a second-stage boot of 256 bytes, too).
StartState start_of(const Image& image, const BoardDescription& board);

}  // namespace spanline::host
