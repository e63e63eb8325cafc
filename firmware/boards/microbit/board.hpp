// BBC micro:bit, a Cortex-M0 with 16 KB RAM, emulated: no panel, it prints what it would have shown.
#pragma once

#include "boards/common/emulated.hpp"

namespace spanline::boards {

constexpr std::uint16_t at_most(std::uint16_t asked, std::uint16_t most) { return asked < most ? asked : most; }

class Board : public EmulatedBoard<128, 64, PixelFormat::grey4> {
 public:
  // Pools for 16 KB, stack included. The picture stays the same.
  static constexpr Budget fit(const Budget& asked) {
    return asked.walker == Walker::edges ? few_looks(asked) : few_blocks(asked);
  }

 private:
  static constexpr Budget few_looks(const Budget& asked) {
    Budget budget = asked;
    budget.looks = 31;
    budget.planes = at_most(asked.planes, 7);
    return budget;
  }
  // Short bands, no vertex kept, what one line needs.
  static constexpr Budget few_blocks(const Budget& asked) {
    Budget budget = asked;
    budget.band_lines = 16;
    budget.vertices = 0;
    budget.facets = at_most(asked.facets, 160);
    budget.polygons = at_most(asked.polygons, 80);
    budget.segments = at_most(asked.segments, 80);
    budget.edges = at_most(asked.edges, 24);
    budget.active = 10;
    budget.samples = 24;
    budget.implied = 2;
    return budget;
  }
};

}  // namespace spanline::boards
