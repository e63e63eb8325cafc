// Compiled once for each real board, with its folder on the include path: the panel that it names.
#include "boards/screen_of_board.hpp"

#include "board.hpp"
#include "hal/panel/panels.hpp"

namespace spanline::boards {
namespace {

using BoardPanel = Board::Panel;
static_assert(hal::Panel<BoardPanel>);
constexpr Screen kScreen{BoardPanel::kWidth, BoardPanel::kHeight, BoardPanel::kFormat};

template <const hal::DcsTraits& kTraits, hal::Rotation kRotation, typename Wiring>
constexpr BoardScreen of(const hal::DcsPanel<kTraits, kRotation, Wiring>*) {
  return {kScreen, &kTraits, static_cast<std::uint8_t>(kRotation)};
}

template <const hal::SsdTraits& kTraits, hal::Rotation kRotation, typename Wiring>
constexpr BoardScreen of(const hal::SsdGreyPanel<kTraits, kRotation, Wiring>*) {
  return {kScreen, &kTraits, static_cast<std::uint8_t>(kRotation)};
}

}  // namespace

extern const BoardScreen SPANLINE_SCREEN_NAME;
const BoardScreen SPANLINE_SCREEN_NAME = of(static_cast<const BoardPanel*>(nullptr));

}  // namespace spanline::boards
