// What the frames of a run say: how long they take, which line is the worst and why, what bounds the frame rate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mcu/machine.hpp"

namespace spanline::host {

struct Spread {
  std::uint64_t least = 0, median = 0, most = 0;
};

// The median of an even number is the upper one.
Spread spread_of(std::vector<std::uint64_t> values);

struct FrameReport {
  // Of the picture.
  struct Line {
    std::uint64_t compute;  // cycles, stalls included, waiting not
    std::uint64_t bytes;    // of its pixels that were sent
    std::uint64_t wire;     // cycles from its first bit to its last; 0 where nothing was sent
    // Cycles it was ready before the wire was; negative: the wire waited for it. Nothing where nothing was sent, now or
    // before.
    std::optional<std::int64_t> slack;
  };
  struct WorstLine {
    std::size_t frame, line;
    std::uint64_t compute;
    Stage stage;  // in which it takes the most above the median line
    std::uint64_t in_stage, usual;
  };
  struct Rate {
    double compute = 0, wire = 0, both = 0;  // frames a second if only that mattered; both: as it ran
  };

  std::uint32_t kilohertz = 0;
  Spread cycles, instructions;            // a frame: core cycles and stalls without waiting; instructions with it
  Spread prepare_cycles;                  // before a frame's first line
  Spread line_cycles, line_instructions;  // a line
  std::size_t worst_frame = 0;
  std::optional<WorstLine> worst_line;
  Rate rate;           // of the whole animation
  Rate worst_rate;     // of its worst frame
  double overlap = 0;  // part of the wire's time in which the core works
  // The most that a frame took of what it would if nothing but the longer of computing and sending each line, and what
  // comes before the first, took time. 0 without lines or a cycle model.
  double pace = 0;
  std::uint64_t bytes = 0;            // a frame, on the wire
  std::vector<Line> lines;            // of the worst frame
  std::optional<std::uint32_t> ring;  // line buffers with which the wire never waits in the worst frame
  StageCounts stages{};               // of all frames
  Count total;                        // of all frames
};

// Nothing where the run has no frames.
std::optional<FrameReport> frame_report(const RunReport& run, std::uint32_t kilohertz);

}  // namespace spanline::host
