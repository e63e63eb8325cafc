// The boards of firmware/boards and the panel of each.
#pragma once

#include <string>
#include <vector>

#include "core/geom/screen.hpp"

namespace spanline::host {

struct Board {
  const char* name;
  Screen panel;
};

const std::vector<Board>& boards();

// The board of this name. Throws UsageError with the names that there are.
const Board& find_board(const std::string& name);

}  // namespace spanline::host
