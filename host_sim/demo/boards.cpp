#include "demo/boards.hpp"

#include "demo/names.hpp"

namespace spanline::host {

const std::vector<Board>& boards() {
  constexpr Screen kWide{320, 240, PixelFormat::rgb565}, kTall{240, 320, PixelFormat::rgb565};
  constexpr Screen kSquare{240, 240, PixelFormat::rgb565}, kOled{128, 64, PixelFormat::grey4};
  static const std::vector<Board> all = {
      {"ek-lm3s6965", "ssd0323", 0, kOled},
      {"stm32f429i-disc1", "ili9341", 0, kTall},
      {"nucleo-f411re", "st7789-240x240", 0, kSquare},
      {"pico", "st7789", 1, kWide},
      {"mps2-an385", nullptr, 0, kWide},
      {"mps2-an386", nullptr, 0, kWide},
      {"mps2-an500", nullptr, 0, kWide},
      {"mps2-an505", nullptr, 0, kWide},
      {"microbit", nullptr, 0, kOled},
  };
  return all;
}

const Board& find_board(const std::string& name) {
  return by_name("--board", boards(), name, [](const Board& board) { return board.name; });
}

}  // namespace spanline::host
