#include "core/frame/piece_shade.hpp"

#include "core/shade/pixel.hpp"

namespace spanline {
namespace {

constexpr int kWhole = 22;  // fraction bits of one over the points of a piece

std::int32_t magnitude(std::int32_t v) { return v < 0 ? -v : v; }

// Cells along a direction: a chord leaves its curve by 3/4 of a second difference of the control points at most.
std::uint32_t cells_along(const ScreenPiece& piece, bool rows) {
  std::int32_t most = 0;
  for (int line = 0; line < 4; ++line) {
    for (int k = 0; k < 2; ++k) {
      std::int32_t bend[2];
      for (int axis = kPointX; axis <= kPointY; ++axis) {
        const auto& at = piece.at[axis];
        const auto p = [&](int i) { return rows ? at[line][i] : at[i][line]; };
        bend[axis] = magnitude((p(k + 2) - p(k + 1)) - (p(k + 1) - p(k)));
      }
      const std::int32_t sum = bend[0] > bend[1] ? bend[0] + bend[1] / 2 : bend[1] + bend[0] / 2;
      most = sum > most ? sum : most;
    }
  }
  constexpr std::int32_t kHalfPixel = (1 << (kPointBits - 1)) / 3 * 4;
  return most <= kHalfPixel ? 1 : most <= 4 * kHalfPixel ? 2 : 4;
}

// Levels of halving that NormalGrid has steps for; finer places share normals.
constexpr std::uint32_t kNormalLevels = 7;
static_assert(NormalGrid::kMostSteps == 1u << kNormalLevels);

// Place `at` of a piece's range cut into 2^levels.
struct Place {
  std::uint32_t at, of;
};
Place place(const PieceRange& range, std::uint32_t at, std::uint32_t levels) {
  std::uint32_t whole = (range.index << levels) + at, level = range.level + levels;
  if (level > kNormalLevels) {
    whole >>= level - kNormalLevels;
    level = kNormalLevels;
  }
  return {whole, 1u << level};
}
std::uint32_t levels_of(std::uint32_t cells) { return cells >> 1; }  // 1, 2, 4
static_assert(1 >> 1 == 0 && 2 >> 1 == 1 && 4 >> 1 == 2);

}  // namespace

PieceShade::PieceShade(const ScreenPiece& piece, const PatchShape& shape, const PatchLook& look)
    : format_(look.format),
      gouraud_(look.gouraud),
      rows_(piece.rows),
      columns_(piece.columns),
      cells_{cells_along(piece, false), cells_along(piece, true)},
      inverse_((1u << kWhole) / (piece.rows * piece.columns)),
      inverse_columns_((1u << 16) / piece.columns + 1) {
  sides_[0].shown = piece.side != PieceSide::back;
  sides_[1].shown = piece.side != PieceSide::front && look.two_sided;
  if (gouraud_) {
    light_corners(piece, shape, look);
  } else {
    light_flat(piece, shape, look);
  }
}
static_assert(kMostPieceSteps * 4 * (kMostPieceSteps + 1) < 1 << 16, "cells come out right");

void PieceShade::light_flat(const ScreenPiece& piece, const PatchShape& shape, const PatchLook& look) {
  const std::uint32_t along_v = piece.turned ? cells_[1] : cells_[0], along_u = piece.turned ? cells_[0] : cells_[1];
  for (std::uint32_t i = 0; i < along_v; ++i) {
    const Place v = place(piece.v, 2 * i + 1, levels_of(along_v) + 1);
    const NormalRow normals(PatchTangents(shape, {v.of, place(piece.u, 0, levels_of(along_u) + 1).of}), v.at);
    for (std::uint32_t j = 0; j < along_u; ++j) {
      const Normal10 normal = normals.at(place(piece.u, 2 * j + 1, levels_of(along_u) + 1).at);
      for (int s = 0; s < 2; ++s) {
        if (!sides_[s].shown) continue;
        std::uint16_t& flat = piece.turned ? sides_[s].flat[j][i] : sides_[s].flat[i][j];
        flat = flat_payload(format_, look.lights->shade(normal, *look.material, s == 1));
      }
    }
  }
}

void PieceShade::light_corners(const ScreenPiece& piece, const PatchShape& shape, const PatchLook& look) {
  const std::uint32_t along_v = piece.turned ? cells_[1] : cells_[0], along_u = piece.turned ? cells_[0] : cells_[1];
  for (std::uint32_t i = 0; i <= along_v; ++i) {
    const Place v = place(piece.v, i, levels_of(along_v));
    const NormalRow normals(PatchTangents(shape, {v.of, place(piece.u, 0, levels_of(along_u)).of}), v.at);
    for (std::uint32_t j = 0; j <= along_u; ++j) {
      const Normal10 normal = normals.at(place(piece.u, j, levels_of(along_u)).at);
      for (int s = 0; s < 2; ++s) {
        if (!sides_[s].shown) continue;
        const Rgb8 color = look.lights->shade(normal, *look.material, s == 1);
        auto& corner = piece.turned ? sides_[s].corner[j][i] : sides_[s].corner[i][j];
        corner[0] = color.r;
        corner[1] = color.g;
        corner[2] = color.b;
      }
    }
  }
}

void PieceShade::begin_row(std::uint32_t index) {
  const std::uint32_t at = index * cells_[0];
  cell_row_ = index == rows_ ? cells_[0] - 1 : at / rows_;
  if (!gouraud_) return;
  const std::uint32_t below = at - cell_row_ * rows_, above = rows_ - below;
  for (Side& side : sides_) {
    if (!side.shown) continue;
    for (std::uint32_t j = 0; j <= cells_[1]; ++j) {
      for (int i = 0; i < 3; ++i) {
        side.channel[j][i] = side.corner[cell_row_][j][i] * above + side.corner[cell_row_ + 1][j][i] * below;
      }
    }
  }
}

std::uint16_t PieceShade::mixed(const Side& side, std::uint32_t cell, std::uint32_t part) const {
  const auto channel = [&](int i) {
    const std::uint32_t sum = side.channel[cell][i] * (columns_ - part) + side.channel[cell + 1][i] * part;
    return static_cast<std::uint8_t>((sum * inverse_ + (1u << (kWhole - 1))) >> kWhole);
  };
  static_assert(255u << kWhole < 1u << 31, "a channel and its rounding fit a word");
  return flat_payload(format_, {channel(0), channel(1), channel(2)});
}

}  // namespace spanline
