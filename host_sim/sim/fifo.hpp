// The buffer between a visible segment generator and a display of constant line rate (seed 1, VII.D).
#pragma once

#include <cstdint>
#include <vector>

namespace spanline::host {

// What one scan line cost and gave.
struct LineLoad {
  std::uint32_t references;  // reads and writes of segment blocks
  std::uint32_t segments;    // visible segments put out, background runs too
};

// The smallest number of segments that a buffer must hold so that a display at 30 frames a second never starves, when
// each reference takes 200 ns.
//
// Model: line i of H is on the display from i * T to (i + 1) * T, T = 1 / (30 H) s, and takes its segments from the
// buffer evenly over that time. The generator works on line i for 200 ns * references and puts its segments in evenly
// over that time. It may begin before the display does and it waits while the buffer is full. The least buffer is the
// one of the generator that works as late as it may without starving the display: at no moment can any other hold less.
// Its content counts whenever a line is finished, rounded up, at least 1.
std::uint32_t fifo_segments(const std::vector<LineLoad>& lines);

}  // namespace spanline::host
