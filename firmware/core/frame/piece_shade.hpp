// How the points of a piece are lit: as diced facets are. The piece is divided into cells that its curves leave by no
// more than half a pixel; a cell has one colour, by the patch's normal at its middle, where it is flat, or one at each
// corner and between them what is bilinear.
#pragma once

#include "core/curve/point_piece.hpp"
#include "core/frame/patch_source.hpp"

namespace spanline {

// Colours as payloads.
class PieceShade {
 public:
  PieceShade(const ScreenPiece& piece, const PatchShape& shape, const PatchLook& look);

  void begin_row(std::uint32_t index);
  // Of a point of the row.
  std::uint16_t payload(bool front, std::uint32_t column) const {
    const std::uint32_t at = column * cells_[1], cell = at * inverse_columns_ >> 16;
    const Side& side = sides_[front ? 0 : 1];
    return gouraud_ ? mixed(side, cell, at - cell * columns_)
                    : side.flat[cell_row_][cell < cells_[1] ? cell : cell - 1];
  }

 private:
  static constexpr std::uint32_t kMostCells = 4;  // each way
  struct Side {
    union {
      std::uint8_t corner[kMostCells + 1][kMostCells + 1][3];
      std::uint16_t flat[kMostCells][kMostCells];
    };
    std::uint32_t channel[kMostCells + 2]
                         [3];  // of the current row, times its piece's rows; the last one weighs nothing
    bool shown;
  };
  void light_flat(const ScreenPiece& piece, const PatchShape& shape, const PatchLook& look);
  void light_corners(const ScreenPiece& piece, const PatchShape& shape, const PatchLook& look);
  std::uint16_t mixed(const Side& side, std::uint32_t cell, std::uint32_t part) const;

  Side sides_[2];
  PixelFormat format_;
  bool gouraud_;
  std::uint32_t rows_, columns_;
  std::uint32_t cells_[2];  // along columns, along rows
  std::uint32_t cell_row_ = 0;
  std::uint32_t inverse_;          // 2^22 / (rows * columns)
  std::uint32_t inverse_columns_;  // 2^16 / columns, rounded up
};

}  // namespace spanline
