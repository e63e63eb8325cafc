#include "core/frame/point_source.hpp"

namespace spanline {

// A patch at work.
struct PointSource::Job {
  const PatchLook& look;
  PointWindow window;
  std::uint16_t face;
  std::int32_t farthest;  // Q16.10: nothing beyond is drawn
  PatchShape shape;
};

void PointSource::begin_band(std::int32_t top, std::int32_t bottom) {
  top_ = top;
  bottom_ = bottom;
  const std::uint32_t count = static_cast<std::uint32_t>(bottom - top) * screen_.width;
  for (std::uint32_t i = 0; i < count; ++i) p_.cells[i] = 0;
}

void PointSource::plot(const FacetReader& reader, std::uint16_t face, const PatchLook& look) {
  const Projection& projection = reader.projection();
  Job job{look, {top_, bottom_, screen_.width}, face, 0, {}};
  job.farthest = static_cast<std::int32_t>(projection.depth(projection.far_w) << (kPointDepthBits - 8));
  ClipPatch patch;
  for (std::uint32_t i = 0; i < 16; ++i) {
    patch.at[i / 4][i % 4] = reader.control_point(i);
    job.shape.at[i / 4][i % 4] = reader.mesh().positions[reader.face().corners[i]];
  }
  PieceCutter cutter(patch, projection, job.window, reader.mirrored());
  for (ScreenPiece piece; cutter.next(piece);) {
    if (look.two_sided || piece.side != PieceSide::back) plot(job, piece, reader.mirrored());
  }
}

void PointSource::plot(const Job& job, const ScreenPiece& piece, bool mirrored) {
  PieceShade shade(piece, job.shape, job.look);
  PointPixel points[2][kMostPieceSteps + 1];
  std::int32_t turns[kMostPieceSteps + 1];
  const auto front = [&](std::uint32_t column) {
    if (piece.side != PieceSide::mixed) return piece.side == PieceSide::front;
    // Fronts turn to the left, where y points down.
    return mirrored != piece.turned ? turns[column] >= 0 : turns[column] <= 0;
  };
  PointRows rows(piece);
  bool had_above = false;
  for (std::uint32_t row = 0; row <= piece.rows; ++row, rows.step()) {
    const bool meets = rows.meets(job.window);
    if (meets) {
      const PointPixel* const above = points[(row + 1) % 2];
      PointPixel* const below = points[row % 2];
      rows.step_off(below);
      points_ += piece.columns + 1;
      shade.begin_row(row);
      if (piece.side == PieceSide::mixed) rows.turns(turns);
      for (std::uint32_t i = 0; i <= piece.columns; ++i) put(below[i], job, shade, front(i), i);
      if (had_above) {
        fill_diamonds(above, below, piece.columns, [&](std::uint32_t column, const PointPixel& pixel) {
          put(pixel, job, shade, front(column), column);
        });
      }
    }
    had_above = meets;
  }
}

void PointSource::put(const PointPixel& point, const Job& job, const PieceShade& shade, bool front,
                      std::uint32_t column) {
  constexpr std::int32_t kNear = std::int32_t{1} << (16 + kPointDepthBits);
  if (point.x < 0 || point.x >= job.window.width || point.y < top_ || point.y >= bottom_) return;
  if (point.depth > kNear || point.depth < job.farthest) return;
  if (!front && !job.look.two_sided) return;
  const std::uint32_t depth =
      static_cast<std::uint32_t>(point.depth - (point.depth == kNear ? 1 : 0)) >> kPointDepthBits;
  const std::uint32_t index =
      static_cast<std::uint32_t>(point.y - top_) * screen_.width + static_cast<std::uint32_t>(point.x);
  std::uint32_t& cell = p_.cells[index];
  if (depth < cell >> 16) return;
  // Depth 0 is that of an empty cell.
  const std::uint32_t word = (depth == 0 ? 1 : depth) << 16 | shade.payload(front, column);
  if (word <= cell) return;
  cell = word;
  if (!p_.faces.empty()) p_.faces[index] = job.face;
}

}  // namespace spanline
