// Arm MPS2 with AN385, a Cortex-M3, emulated: no panel, it prints what it would have shown.
#pragma once

#include "boards/common/emulated.hpp"

namespace spanline::boards {

using Board = EmulatedBoard<320, 240, PixelFormat::rgb565>;

}  // namespace spanline::boards
