// The boards of firmware/boards and the panel of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geom/screen.hpp"

namespace spanline::host {

struct Board {
  const char* name;
  const char* panel;      // the name of its driver as --panel takes it; null where it exists for an emulator only
  std::uint8_t rotation;  // 0 to 3
  Screen screen;          // what that is to the engine
};

const std::vector<Board>& boards();

// The board of this name. Throws UsageError with the names that there are.
const Board& find_board(const std::string& name);

}  // namespace spanline::host
