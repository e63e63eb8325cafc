#pragma once

#include <cstdint>

#include "core/geom/screen.hpp"

namespace spanline::boards {

// The panel that a board's own type names.
struct BoardScreen {
  Screen screen;
  const void* traits;  // of its driver: the controller on its glass
  std::uint8_t rotation;
};

}  // namespace spanline::boards
