// The host draws the demos for the panels that the boards have.
#include <gtest/gtest.h>

#include "demo/boards.hpp"

namespace spanline::boards {

extern const Screen screen_of_ek_lm3s6965, screen_of_stm32f429i_disc1, screen_of_nucleo_f411re, screen_of_pico;

namespace {

TEST(Screens, AreTheSameForTheHost) {
  const struct {
    const char* name;
    const Screen& screen;
  } boards[] = {{"ek-lm3s6965", screen_of_ek_lm3s6965},
                {"stm32f429i-disc1", screen_of_stm32f429i_disc1},
                {"nucleo-f411re", screen_of_nucleo_f411re},
                {"pico", screen_of_pico}};
  for (const auto& board : boards) {
    const Screen& of_host = host::find_board(board.name).panel;
    EXPECT_EQ(of_host.width, board.screen.width) << board.name;
    EXPECT_EQ(of_host.height, board.screen.height) << board.name;
    EXPECT_EQ(of_host.format, board.screen.format) << board.name;
  }
}

}  // namespace
}  // namespace spanline::boards
