// The host draws the demos through the panels that the boards have.
#include <gtest/gtest.h>

#include "boards/screen_of_board.hpp"
#include "demo/boards.hpp"
#include "hal/panel/panels.hpp"
#include "panel/panel_run.hpp"

namespace spanline::boards {

extern const BoardScreen screen_of_ek_lm3s6965, screen_of_stm32f429i_disc1, screen_of_nucleo_f411re, screen_of_pico;

namespace {

TEST(Screens, AreTheSameForTheHost) {
  const struct {
    const char* name;
    const BoardScreen& own;
    const char* panel;   // as --panel names the driver
    const void* traits;  // of the driver of that name
  } boards[] = {{"ek-lm3s6965", screen_of_ek_lm3s6965, "ssd0323", &hal::kSsd0323},
                {"stm32f429i-disc1", screen_of_stm32f429i_disc1, "ili9341", &hal::kIli9341},
                {"nucleo-f411re", screen_of_nucleo_f411re, "st7789-240x240", &hal::kSt7789Square},
                {"pico", screen_of_pico, "st7789", &hal::kSt7789}};
  for (const auto& board : boards) {
    const host::Board& of_host = host::find_board(board.name);
    EXPECT_EQ(of_host.screen.width, board.own.screen.width) << board.name;
    EXPECT_EQ(of_host.screen.height, board.own.screen.height) << board.name;
    EXPECT_EQ(of_host.screen.format, board.own.screen.format) << board.name;
    EXPECT_STREQ(of_host.panel, board.panel);
    EXPECT_EQ(board.own.traits, board.traits) << board.name;
    EXPECT_EQ(of_host.rotation, board.own.rotation) << board.name;
    const auto run = host::PanelRun::make(of_host.panel, static_cast<hal::Rotation>(of_host.rotation));
    ASSERT_NE(run, nullptr) << board.name;
    EXPECT_EQ(run->width(), board.own.screen.width) << board.name;
    EXPECT_EQ(run->height(), board.own.screen.height) << board.name;
    EXPECT_EQ(run->format(), board.own.screen.format) << board.name;
  }
}

}  // namespace
}  // namespace spanline::boards
