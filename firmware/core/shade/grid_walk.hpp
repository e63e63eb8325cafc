// The walk of a line of RGB565 whose faces lie in a grid and have one colour a cell: walk_on() with fill_span().
#pragma once

#include <cstddef>

#include "core/shade/fill_words.hpp"

namespace spanline {

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
// In assembly.
WalkStop walk_grid_cells(LineWalk& walk, FaceId shown) asm("spanline_grid_walk");
WalkStop walk_grid_line(LineWalk& walk) asm("spanline_grid_line");
#endif

// LineWalk::faces are Cells; the faces 2 n and 2 n + 1 have the colour of cell n, its first member. For any core.
template <typename Cell>
WalkStop grid_walk_plain(LineWalk& walk, FaceId shown) {
  const auto paint = [pixels = walk.pixels, cells = static_cast<const Cell*>(walk.faces)](
                         std::int32_t left, std::int32_t right, FaceId face) {
    fill_span(pixels, left, right, cells[face / 2u].color);
    return true;
  };
  return walk_on(walk, shown, paint);
}

template <typename Cell>
WalkStop grid_walk(LineWalk& walk, FaceId shown) {
  static_assert(sizeof(Cell) == 12 && offsetof(Cell, color) == 0 && sizeof(Cell::color) == 2, "assembly knows it");
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
  return walk_grid_cells(walk, shown);
#else
  return grid_walk_plain<Cell>(walk, shown);
#endif
}

// The same from the beginning of a line.
template <typename Cell>
WalkStop grid_line(LineWalk& walk) {
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
  return walk_grid_line(walk);
#else
  walk.begin_line();
  return grid_walk<Cell>(walk, 0);
#endif
}

}  // namespace spanline
