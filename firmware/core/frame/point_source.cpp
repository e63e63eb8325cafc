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

std::int32_t PointSource::distance(const FacetReader& reader) {
  std::int32_t sum = 0;
  for (const std::uint32_t corner : {0u, 3u, 12u, 15u}) sum += reader.control_point(corner).w / 4;
  return sum;
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

// What some control points reach to: x and y, Q13.19.
struct PointSource::Reach {
  std::int32_t least[2] = {INT32_MAX, INT32_MAX}, most[2] = {INT32_MIN, INT32_MIN};

  void add(int axis, std::int32_t v) {
    least[axis] = v < least[axis] ? v : least[axis];
    most[axis] = v > most[axis] ? v : most[axis];
  }
};

// Whether all pixels that points within the reach may lie in show something nearer than `nearest`, Q16.
bool PointSource::hidden(const Job& job, const Reach& reach, std::int32_t nearest) const {
  constexpr std::int32_t kRounding = 1 << (kPointBits - 4);  // what rounding may add on the way is less
  const auto begin = [](std::int32_t v, std::int32_t low) {
    const std::int32_t px = (v - kRounding) >> kPointBits;
    return px > low ? px : low;
  };
  const auto end = [](std::int32_t v, std::int32_t high) {
    const std::int32_t px = ((v + kRounding) >> kPointBits) + 1;
    return px < high ? px : high;
  };
  const std::int32_t left = begin(reach.least[kPointX], 0), right = end(reach.most[kPointX], job.window.width);
  const std::int32_t bottom = end(reach.most[kPointY], bottom_);
  for (std::int32_t y = begin(reach.least[kPointY], top_); y < bottom; ++y) {
    const std::uint32_t* const line = p_.cells.data() + static_cast<std::uint32_t>((y - top_) * job.window.width);
    for (std::int32_t x = left; x < right; ++x) {
      if (static_cast<std::int32_t>(line[x] >> 16) <= nearest) return false;
    }
  }
  return true;
}

bool PointSource::hidden(const Job& job, const PointRows& row, std::int32_t nearest) const {
  Reach reach;
  for (int j = 0; j < 4; ++j) {
    for (const PointAxis axis : {kPointX, kPointY}) reach.add(axis, row.control(axis, j));
  }
  return hidden(job, reach, nearest);
}

void PointSource::plot(const Job& job, const ScreenPiece& piece) {
  Reach reach;
  std::int32_t nearest = 0;
  for (int i = 0; i < 16; ++i) {
    for (int axis = kPointX; axis <= kPointY; ++axis) reach.add(axis, piece.at[axis][i / 4][i % 4]);
    const std::int32_t depth = piece.at[kPointDepth][i / 4][i % 4];
    nearest = depth > nearest ? depth : nearest;
  }
  nearest = (nearest >> kPointDepthBits) + 1;
  if (hidden(job, reach, nearest)) return;
  PieceShade shade(piece, job.shape, job.look);
  plot_rows(job, piece, nearest, shade);
}

// A row is passed over where nothing of the whole piece could be seen in its pixels: a diamond beside it, whose middle
// is among them, cannot be either.
void PointSource::plot_rows(const Job& job, const ScreenPiece& piece, std::int32_t nearest, PieceShade& shade) {
  const bool mixed = piece.side == PieceSide::mixed;
  PointPixel points[2][kMostPieceSteps + 1];
  std::int32_t turns[kMostPieceSteps + 1];
  // Where y points down, fronts turn to the left.
  const Row row{shade, mixed ? turns : nullptr, piece.side == PieceSide::front, job.mirrored == piece.turned};
  PointRows rows(piece);
  bool had_above = false;
  for (std::uint32_t index = 0; index <= piece.rows; ++index, rows.step()) {
    const bool seen = rows.meets(job.window) && !hidden(job, rows, nearest);
    if (seen) {
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
    had_above = seen;
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
