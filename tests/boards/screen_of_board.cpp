// Compiled once for each real board, with its folder on the include path: the panel that it names.
#include "board.hpp"
#include "core/geom/screen.hpp"

namespace spanline::boards {

using BoardPanel = Board::Panel;
static_assert(hal::Panel<BoardPanel>);

extern const Screen SPANLINE_SCREEN_NAME;
const Screen SPANLINE_SCREEN_NAME{BoardPanel::kWidth, BoardPanel::kHeight, BoardPanel::kFormat};

}  // namespace spanline::boards
