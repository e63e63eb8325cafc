// What an image takes of flash and RAM.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mcu/board.hpp"
#include "mcu/image.hpp"

namespace spanline::host {

struct MemoryReport {
  struct Part {
    std::string name;
    std::uint32_t flash, ram;  // bytes
  };
  std::vector<Part> sections;  // in the order of the file
  std::vector<Part> symbols;   // largest first
  std::vector<Part> rooms;     // by the source's folder, largest first; what no symbol names is no room's
  std::uint32_t flash = 0, ram = 0;
  std::uint32_t flash_of_board = 0, ram_of_board = 0;
};

// Initialized data takes both: its contents lie in flash, start-up copies them.
// Rooms come from the image's debug information.
MemoryReport memory_report(const Image& image, const BoardDescription& board);

}  // namespace spanline::host
