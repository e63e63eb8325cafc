#include "core/frame/point_source.hpp"

namespace spanline {

namespace {

constexpr std::int32_t kNear = std::int32_t{1} << (16 + kPointDepthBits);  // depth of the near plane, Q16.10

}  // namespace

// A patch at work.
struct PointSource::Job {
  const PatchLook& look;
  PointWindow window;
  std::uint16_t face;
  bool mirrored;
  std::int32_t farthest;  // Q16.10: nothing beyond is drawn
  PatchShape shape;
};

// A row of a piece at work.
struct PointSource::Row {
  const PieceShade& shade;
  const std::int32_t* turns;  // by which side the points turn; null: `front` says it of all
  bool front;
  bool left_is_front;

  bool is_front(std::uint32_t column) const {
    if (turns == nullptr) return front;
    return left_is_front ? turns[column] <= 0 : turns[column] >= 0;
  }
};

void PointSource::begin_band(std::int32_t top, std::int32_t bottom) {
  top_ = top;
  bottom_ = bottom;
  const std::uint32_t count = static_cast<std::uint32_t>(bottom - top) * screen_.width;
  for (std::uint32_t i = 0; i < count; ++i) p_.cells[i] = 0;
}

void PointSource::plot(const FacetReader& reader, std::uint16_t face, const PatchLook& look) {
  const Projection& projection = reader.projection();
  Job job{look, {top_, bottom_, screen_.width}, face, reader.mirrored(), 0, {}};
  job.farthest = static_cast<std::int32_t>(projection.depth(projection.far_w) << (kPointDepthBits - 8));
  ClipPatch patch;
  for (std::uint32_t i = 0; i < 16; ++i) {
    patch.at[i / 4][i % 4] = reader.control_point(i);
    job.shape.at[i / 4][i % 4] = reader.mesh().positions[reader.face().corners[i]];
  }
  PieceCutter cutter(patch, projection, job.window, job.mirrored);
  for (ScreenPiece piece; cutter.next(piece);) {
    if (look.two_sided || piece.side != PieceSide::back) plot(job, piece);
  }
}

// Whether all pixels that the piece may have a point in show something nearer than it comes.
bool PointSource::hidden(const Job& job, const ScreenPiece& piece) const {
  std::int32_t least[kPointAxes], most[kPointAxes];
  for (int axis = 0; axis < kPointAxes; ++axis) {
    least[axis] = most[axis] = piece.at[axis][0][0];
    for (const auto& row : piece.at[axis]) {
      for (const std::int32_t v : row) {
        least[axis] = v < least[axis] ? v : least[axis];
        most[axis] = v > most[axis] ? v : most[axis];
      }
    }
  }
  // What rounding may add on the way is less than that.
  constexpr std::int32_t kRounding = 1 << (kPointBits - 4), kDepthRounding = 1 << 8;
  const auto begin = [](std::int32_t v, std::int32_t low) {
    const std::int32_t px = (v - kRounding) >> kPointBits;
    return px > low ? px : low;
  };
  const auto end = [](std::int32_t v, std::int32_t high) {
    const std::int32_t px = ((v + kRounding) >> kPointBits) + 1;
    return px < high ? px : high;
  };
  const std::int32_t nearest = (most[kPointDepth] + kDepthRounding) >> kPointDepthBits;
  const std::int32_t left = begin(least[kPointX], 0), right = end(most[kPointX], job.window.width);
  const std::int32_t bottom = end(most[kPointY], bottom_);
  for (std::int32_t y = begin(least[kPointY], top_); y < bottom; ++y) {
    const std::uint32_t* const line = p_.cells.data() + static_cast<std::uint32_t>((y - top_) * job.window.width);
    for (std::int32_t x = left; x < right; ++x) {
      if (static_cast<std::int32_t>(line[x] >> 16) <= nearest) return false;
    }
  }
  return true;
}

void PointSource::plot(const Job& job, const ScreenPiece& piece) {
  if (hidden(job, piece)) return;
  PieceShade shade(piece, job.shape, job.look);
  plot_rows(job, piece, shade);
}

void PointSource::plot_rows(const Job& job, const ScreenPiece& piece, PieceShade& shade) {
  const bool mixed = piece.side == PieceSide::mixed;
  PointPixel points[2][kMostPieceSteps + 1];
  std::int32_t turns[kMostPieceSteps + 1];
  // Where y points down, fronts turn to the left.
  const Row row{shade, mixed ? turns : nullptr, piece.side == PieceSide::front, job.mirrored == piece.turned};
  PointRows rows(piece);
  bool had_above = false;
  for (std::uint32_t index = 0; index <= piece.rows; ++index, rows.step()) {
    const bool meets = rows.meets(job.window);
    if (meets) {
      const PointPixel* const above = points[(index + 1) % 2];
      PointPixel* const below = points[index % 2];
      rows.step_off(below);
      if (mixed) rows.turns(turns);
      points_ += piece.columns + 1;
      shade.begin_row(index);
      put(job, row, below, 0, piece.columns + 1);
      if (had_above) {
        fill_diamonds(above, below, piece.columns,
                      [&](std::uint32_t column, const PointPixel& pixel) { put(job, row, &pixel, column, 1); });
      }
    }
    had_above = meets;
  }
}

// What does not change from point to point is at hand in locals: the cells written might be it, for all the compiler
// knows.
void PointSource::put(const Job& job, const Row& row, const PointPixel* points, std::uint32_t column,
                      std::uint32_t count) {
  const auto width = static_cast<std::uint32_t>(job.window.width);
  const auto lines = static_cast<std::uint32_t>(job.window.bottom - job.window.top);
  const std::int32_t top = job.window.top, farthest = job.farthest;
  const bool two_sided = job.look.two_sided;
  std::uint32_t* const cells = p_.cells.data();
  std::uint16_t* const faces = p_.faces.data();
  for (const std::uint32_t end = column + count; column != end; ++column, ++points) {
    const auto x = static_cast<std::uint32_t>(points->x), y = static_cast<std::uint32_t>(points->y - top);
    if (x >= width || y >= lines) continue;
    const std::uint32_t at = y * width + x, old = cells[at];
    const std::int32_t depth = points->depth;
    if (depth >> kPointDepthBits < static_cast<std::int32_t>(old >> 16)) continue;
    if (depth > kNear || depth < farthest) continue;
    const bool front = row.is_front(column);
    if (!front && !two_sided) continue;
    // Depth 0 is that of an empty cell, and the near plane's would need another bit.
    const std::uint32_t nearness = static_cast<std::uint32_t>(depth - (depth == kNear ? 1 : 0)) >> kPointDepthBits;
    const std::uint32_t word = (nearness == 0 ? 1 : nearness) << 16 | row.shade.payload(front, column);
    if (word <= old) continue;
    cells[at] = word;
    if (faces != nullptr) faces[at] = job.face;
  }
}

}  // namespace spanline
