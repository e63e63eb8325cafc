#include "demo/boards.hpp"

#include "demo/names.hpp"

namespace spanline::host {

const std::vector<Board>& boards() {
  static const std::vector<Board> all = {
      {"ek-lm3s6965", {128, 64, PixelFormat::grey4}},     {"stm32f429i-disc1", {240, 320, PixelFormat::rgb565}},
      {"nucleo-f411re", {240, 240, PixelFormat::rgb565}}, {"pico", {320, 240, PixelFormat::rgb565}},
      {"mps2-an385", {320, 240, PixelFormat::rgb565}},    {"mps2-an386", {320, 240, PixelFormat::rgb565}},
      {"mps2-an500", {320, 240, PixelFormat::rgb565}},    {"mps2-an505", {320, 240, PixelFormat::rgb565}},
      {"microbit", {128, 64, PixelFormat::grey4}}};
  return all;
}

const Board& find_board(const std::string& name) {
  return by_name("--board", boards(), name, [](const Board& board) { return board.name; });
}

}  // namespace spanline::host
