// The walk of a line of RGB565 whose faces lie in a grid, and are smooth: walk_on() with smooth_span().
#pragma once

#include <cstddef>

#include "core/shade/smooth_walk.hpp"

namespace spanline {

// Where a face's look is among those that are kept: its cell says so in the upper byte of its first member.
template <typename Cell>
struct LookCells {
  const Cell* cells = nullptr;
  std::uint32_t operator()(FaceId face) const { return std::uint32_t{cells[face / 2u].color} >> 8; }
};
template <typename Cell>
using GridBrush = Brush<LookCells<Cell>>;

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
// In assembly.
WalkStop walk_smooth_grid_cells(LineWalk& walk, FaceId shown) asm("spanline_smooth_grid_walk");
WalkStop walk_smooth_grid_line(LineWalk& walk) asm("spanline_smooth_grid_line");
#endif

// LineWalk::painter is a brush of this type, LineWalk::faces is not used. The faces 2 n and 2 n + 1 are of cell n.
template <typename Cell>
WalkStop smooth_grid_walk(LineWalk& walk, FaceId shown) {
  static_assert(sizeof(Cell) == 12 && offsetof(Cell, color) == 0 && sizeof(Cell::color) == 2, "assembly knows it");
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
  return walk_smooth_grid_cells(walk, shown);
#else
  return smooth_walk_by<GridBrush<Cell>>(walk, shown);
#endif
}

// The same from the beginning of a line.
template <typename Cell>
WalkStop smooth_grid_line(LineWalk& walk) {
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
  return walk_smooth_grid_line(walk);
#else
  walk.begin_line();
  return smooth_grid_walk<Cell>(walk, 0);
#endif
}

}  // namespace spanline
