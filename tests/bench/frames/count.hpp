// What one frame takes on one core.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frames/prepare.hpp"
#include "mcu/machine.hpp"

namespace spanline::bench {

struct FrameCount {
  std::string cpu;  // "m0plus"
  Expected frame;
  host::Count count;
  std::uint32_t memory_bytes, line_bytes, stack_bytes;  // pools and Frame; lines; deepest use
  std::uint32_t text_bytes;                             // of the engine

  std::uint32_t ram_bytes() const { return memory_bytes + line_bytes + stack_bytes; }
};

// Executes the image on a core, counting from mark to mark: its first frames, or all there are.
host::RunReport run_frames(const host::Image& image, const std::string& cpu, unsigned frames);

// Executes IMAGE.elf, whose map lies beside it, and counts its first frame. Throws InputError where the image reports
// anything but the expected picture.
FrameCount count_frame(const std::string& image, const std::string& cpu, const Expected& expected);

// frames.json: an array of scene, cpu, shading, instructions, ram_bytes, text_bytes.
std::string frames_json(const std::vector<FrameCount>& frames);

// The table, with what others take for the same frames.
std::string frames_table(const std::vector<FrameCount>& frames);

}  // namespace spanline::bench
