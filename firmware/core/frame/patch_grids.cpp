#include "core/frame/patch_grids.hpp"

#include <new>

#include "core/vsg/grid_start.hpp"

namespace spanline {

// A grid in the making.
struct PatchGrids::Open {
  std::uint16_t face;
  std::uint32_t header = 0;  // 0: none is open
  std::uint32_t rows = 0;
  std::uint32_t first = 0;   // the patch's row that is its first
  std::uint32_t points = 0;  // entries at the pool's end that hold rows' points
};

// A row of the patch; its vertices stand at the pool's end as long as cells beside it are to be coloured.
struct PatchGrids::Row {
  GridRow grid;
  ClipPoint* vertices;
};

void PatchGrids::begin(std::int32_t top, std::int32_t bottom) {
  top_ = top;
  bottom_ = bottom;
  used_ = 0;
  v_[0].parts = CellParts::kNone;  // what lies before the first grid
}

// Entries of the pool as points.
ClipPoint* PatchGrids::points_at(std::uint32_t first, std::uint32_t count) const {
  static_assert(sizeof(ClipPoint) == sizeof(GridVertex) && alignof(ClipPoint) == alignof(GridVertex));
  for (std::uint32_t i = first; i != first + count; ++i) new (&v_[i]) ClipPoint;
  return std::launder(reinterpret_cast<ClipPoint*>(&v_[first]));
}

bool PatchGrids::dice(const PatchJob& job, const FacetLight& facets, std::uint16_t face) {
  const std::uint16_t before = used_;
  Open grid{face};
  const std::uint32_t stride = job.columns() + 1, end = v_.capacity() + 1u;
  const std::uint32_t other = job.look.gouraud ? 0 : stride;  // cells without a colour need no row any more
  grid.points = stride + other;
  if (grid.points >= end) return false;
  Row rows[2] = {{{}, points_at(end - stride, stride)}, {{}, points_at(end - stride - other, stride)}};
  const Light light(facets, *job.look.material, job.look.format, job.dicer->near());
  ScreenBounds bounds_above;
  for (std::uint32_t i = 0; i <= job.rows(); ++i) {
    const Row& above = rows[(i + 1) % 2];
    Row& below = rows[i % 2];
    job.dicer->next_row(below.grid);
    ScreenBounds bounds, both = bounds_above;
    if (!job.whole) bounds = job.bounds_of(below.grid);
    both.widen(bounds);
    if (i == 0 || !(job.whole || job.window.meets(both))) {
      close(job, grid);
    } else {
      bool room = true;
      if (grid.header == 0) {
        grid.header = used_ + 1u;
        grid.rows = 1;
        grid.first = i - 1;
        room = step_off(job, above, grid, 0);
      }
      if (room) room = step_off(job, below, grid, grid.rows);
      if (!room) {
        used_ = before;
        return false;
      }
      strip(job, light, grid, above, below);
    }
    bounds_above = bounds;
  }
  close(job, grid);
  return true;
}

// Steps a row off that becomes the grid's row `to`. False where it has no room.
bool PatchGrids::step_off(const PatchJob& job, const Row& row, const Open& grid, std::uint32_t to) {
  const std::uint32_t stride = job.columns() + 1, at = grid.header + 1 + to * stride;
  const std::uint32_t used = at + stride - 1 + grid.points;
  if (used > v_.capacity()) return false;
  if (used > most_) most_ = used;
  job.dicer->step_off(row.grid, row.vertices);
  const Projection projection = job.reader.projection();  // what is written is none of it
  const GridVertex::InRow in_row(stride, to == 0);
  const ClipPoint* in = row.vertices;
  for (GridVertex *out = &v_[at], *const end = out + stride; out != end; ++out) {
    GridVertex::put(out, projection, *in++, in_row);
  }
  return true;
}

// Whether more of the cell shows its front than its back, as PatchSource has it.
static bool shows_front(const PatchJob& job, const GridVertex& cell) {
  const std::int32_t area = CellAreas(&cell).both();
  return job.reader.mirrored() ? area > 0 : area < 0;
}

// Culls and colours the cells of the strip between the grid's last row and the row below, and puts that in. A row that
// no seen cell touches is left out where it is the first.
void PatchGrids::strip(const PatchJob& job, const Light& light, Open& grid, const Row& above_row,
                       const Row& below_row) {
  const std::uint32_t stride = job.columns() + 1;
  GridVertex* const above = &v_[grid.header + 1 + (grid.rows - 1) * stride];
  if (note_parts(job, above, above + stride)) {
    if (!job.look.gouraud) color(job, light, above, above_row, below_row);
  } else if (grid.rows == 1) {
    for (std::uint32_t i = 0; i < stride; ++i) {
      above[i] = above[stride + i];
      above[i].first_row = 1;
    }
    ++grid.first;
    return;
  }
  ++grid.rows;
}

// Colours the cells of a strip that are seen.
void PatchGrids::color(const PatchJob& job, const Light& light, GridVertex* cells, const Row& above, const Row& below) {
  if (job.look.two_sided || !light.quick()) return color_any(job, light, cells, above, below);
  const ClipPoint *a = above.vertices, *d = below.vertices;
  for (std::uint32_t i = job.columns(); i != 0; --i, ++cells, ++a, ++d) {
    if (cells->parts != CellParts::kNone) cells->color = light.payload<true>(a[0], a[1], d[1], d[0], false);
  }
}

void PatchGrids::color_any(const PatchJob& job, const Light& light, GridVertex* cells, const Row& above,
                           const Row& below) {
  const ClipPoint *a = above.vertices, *d = below.vertices;
  for (std::uint32_t i = job.columns(); i != 0; --i, ++cells, ++a, ++d) {
    if (cells->parts == CellParts::kNone) continue;
    const bool flip = job.look.two_sided && !shows_front(job, *cells);
    cells->color = light.payload(a[0], a[1], d[1], d[0], flip);
  }
}

// Whether something of a cell may be seen.
static bool meets(const PatchWindow& window, const PackedXY (&corners)[4]) {
  PackedBox box;
  for (const PackedXY& p : corners) box.widen(p);
  return window.meets(ScreenBounds(box));
}

// Notes which parts of the cells between two rows may be seen; returns whether any.
bool PatchGrids::note_parts(const PatchJob& job, GridVertex* above, const GridVertex* below) {
  PackedXY a(above->at), d(below->at);
  const bool two_sided = job.look.two_sided;
  std::uint32_t any = 0;
  for (std::uint32_t i = job.columns(); i != 0; --i, ++above) {
    const PackedXY b(above[1].at), c((++below)->at);
    const std::uint32_t parts = CellParts::of<true>(a, b, c, d, false, two_sided);
    if (parts != CellParts::kNone && (job.whole || meets(job.window, {a, b, c, d}))) {
      above->parts = parts & 7u;
      any = 1;
    }
    a = b;
    d = c;
  }
  return any != 0;
}

void PatchGrids::close(const PatchJob& job, Open& grid) {
  if (grid.header == 0) return;
  GridVertex& header = v_[grid.header];
  header = v_[grid.header + 1];  // its stride
  header.at.x = static_cast<std::int16_t>(grid.rows);
  header.parts = CellParts::kNone;
  header.color = grid.face;
  if (job.look.gouraud) light(job, grid.header, grid.first);
  used_ = static_cast<std::uint16_t>(pack(grid.header, grid.header) - 1);
  grid.header = 0;
}

// Moves the grid at `from` to `to`, which is not behind it, but for rows and columns that no cell touches. Returns
// where the next one goes.
std::uint32_t PatchGrids::pack(std::uint32_t from, std::uint32_t to) {
  const GridVertex header = v_[from];
  const std::uint32_t rows = static_cast<std::uint32_t>(header.at.x), stride = header.stride;
  // Of each row only what lies beyond the columns that are kept already is looked at.
  std::uint32_t top = rows, bottom = 0, left = stride, right = 0;
  const GridVertex* first = &v_[from + 1];
  for (std::uint32_t row = 0; row < rows; ++row, first += stride) {
    std::uint32_t column = 0;
    while (column < stride && first[column].parts == CellParts::kNone) ++column;
    if (column == stride) continue;
    if (row < top) top = row;
    bottom = row;
    if (column < left) left = column;
    if (column > right) right = column;
    for (column = stride - 1; column > right && first[column].parts == CellParts::kNone;) --column;
    right = column;
  }
  if (top == rows) return to;
  const std::uint32_t kept = right - left + 2;
  v_[to] = header;
  v_[to].at.x = static_cast<std::int16_t>(bottom - top + 2);
  v_[to].stride = kept & 0x7fu;
  const GridVertex* in = &v_[from + 1 + top * stride + left];
  GridVertex* out = &v_[to + 1];
  if (in == out && kept == stride) return to + size(to);
  for (std::uint32_t row = top; row <= bottom + 1; ++row, in += stride - kept) {
    for (std::uint32_t i = 0; i < kept; ++i, ++out) {
      *out = *in++;
      out->stride = kept & 0x7fu;
      out->first_row = row == top;
    }
  }
  return to + size(to);
}

void PatchGrids::shrink(std::int32_t bottom) {
  bottom_ = bottom;
  std::uint32_t to = 1;
  for (std::uint32_t from = 1; from <= used_;) {
    const std::uint32_t end = from + size(from);
    for (std::uint32_t i = from + 1; i < end; ++i) {
      if (v_[i].parts == CellParts::kNone) continue;
      const std::uint32_t below = i + v_[i].stride;
      ScreenBounds bounds;
      for (const std::uint32_t corner : {i, i + 1, below + 1, below}) bounds.widen(v_[corner].at);
      if (first_centre(bounds.top) >= bottom) v_[i].parts = CellParts::kNone;
    }
    to = pack(from, to);
    from = end;
  }
  used_ = static_cast<std::uint16_t>(to - 1);
}

void PatchGrids::file(const PoolRef<std::uint16_t>& buckets) {
  GridVertex* const v = &v_[0];
  std::uint16_t* const lists = &buckets[1];
  const std::int32_t top = top_, lines = bottom_ - top_;
  for (std::int32_t i = 0; i < lines; ++i) lists[i] = 0;
  // Whole rows of a grid, from vertex i on; `above`: in the row above that one, or itself where there is none.
  const auto file_rows = [=](std::uint32_t i, std::uint32_t end, const GridVertex* above) {
    std::uint32_t left = CellParts::kNone;  // of the cells left of the vertex
    for (; i != end; ++i, ++above) {
      GridVertex& vertex = v[i];
      const std::uint32_t right = std::uint32_t{vertex.parts} | above->parts, around = left | right;
      left = right;  // none in the last column
      if (around == CellParts::kNone) continue;
      const std::int32_t line = first_centre(vertex.at.y) - top;
      if (line >= lines) continue;
      std::uint16_t& first = lists[line > 0 ? line : 0];
      vertex.next = first & 0x1fffu;
      first = static_cast<std::uint16_t>(i);
    }
  };
  for (std::uint32_t header = 1, end; header <= used_; header = end) {
    end = header + size(header);
    const std::uint32_t first = header + 1, second = first + v[header].stride;
    file_rows(first, second, &v[first]);
    file_rows(second, end, &v[first]);
  }
}

std::uint32_t PatchGrids::corners(FaceId face, const GridVertex* (&corner)[4]) const {
  const GridVertex *const a = &v_[face / 2u], *const d = a + a->stride;
  corner[0] = a;
  corner[1] = a + 1;
  corner[2] = d + 1;
  corner[3] = d;
  if ((a->parts & CellParts::kApart) == 0) return 4;
  if (face % 2u != 0) {
    corner[1] = d + 1;
    corner[2] = d;
  }
  return 3;
}

bool PatchGrids::is_back(FaceId face) const {
  const GridVertex& cell = v_[face / 2u];
  return CellAreas(&cell).is_back(face, (cell.parts & CellParts::kApart) != 0);
}

template <typename Take>
void PatchGrids::each_crossing(FaceId face, std::int32_t line, const Take& take) const {
  const GridVertex* corner[4];
  const std::uint32_t count = corners(face, corner);
  const std::int32_t centre = line * kSubpixels + kSubpixels / 2;
  const GridVertex* from = corner[count - 1];
  bool above = from->at.y <= centre;
  for (std::uint32_t i = 0; i < count; ++i) {
    const GridVertex* const to = corner[i];
    const bool then = to->at.y <= centre;
    if (above != then) above ? take(*from, *to, true) : take(*to, *from, false);
    from = to;
    above = then;
  }
}

bool PatchGrids::find_edge(FaceId face, std::int32_t line, bool down, ScreenEdge& edge) const {
  bool found = false;
  each_crossing(face, line, [&](const GridVertex& top, const GridVertex& bottom, bool runs_down) {
    if (runs_down != down) return;
    edge.top = {top.at, top.depth, {}};
    edge.bottom = {bottom.at, bottom.depth, {}};
    found = true;
  });
  return found;
}

// A unit of DepthReach.
static std::int32_t reach_unit(std::uint32_t depth) {
  return static_cast<std::int32_t>(depth >> (kDepthBits - 16)) + INT16_MIN;
}

void PatchGrids::reach(FaceId face, DepthReach& to) const {
  const GridVertex* const above = &v_[face / 2u];
  const GridVertex* const below = above + above->stride;
  const std::uint32_t a = above->depth, b = above[1].depth, c = below[1].depth, d = below->depth;
  const std::uint32_t low_ab = a < b ? a : b, high_ab = a < b ? b : a;
  const std::uint32_t low_cd = c < d ? c : d, high_cd = c < d ? d : c;
  to.nearest = static_cast<std::int16_t>(reach_unit(high_ab > high_cd ? high_ab : high_cd));
  to.farthest = static_cast<std::int16_t>(reach_unit(low_ab < low_cd ? low_ab : low_cd));
}

GridChord PatchGrids::chord(FaceId face, std::int32_t line) const {
  const std::int32_t centre = line * kSubpixels + kSubpixels / 2;
  std::int32_t x[2]{}, depth[2]{};  // of the edge that runs up, and down
  each_crossing(face, line, [&](const GridVertex& top, const GridVertex& bottom, bool down) {
    const std::int32_t start = reach_unit(top.depth), rise = reach_unit(bottom.depth) - start;
    const std::int32_t along = centre - top.at.y, height = bottom.at.y - top.at.y;
    static_assert(0xffff * std::int64_t{kMaxExtent * kSubpixels - 1} <= INT32_MAX, "from the top to the line");
    depth[down] = start + rise * along / height;
    x[down] = top.at.x + (bottom.at.x - top.at.x) * along / height;
  });
  return {x[0], depth[0], x[1] - x[0], depth[1] - depth[0]};
}

DepthRamp PatchGrids::ramp(FaceId face, std::int32_t line) const {
  SegmentHalf left{}, right{};
  each_crossing(face, line, [&](const GridVertex& top, const GridVertex& bottom, bool down) {
    (down ? left : right) = start_edge({{top.at, top.depth, {}}, {bottom.at, bottom.depth, {}}}, line, true);
  });
  return left.column < right.column ? depth_between(left, right) : depth_between(right, left);
}

std::uint16_t PatchGrids::scene_face(FaceId face) const {
  std::uint32_t header = 1;
  while (header + size(header) <= face / 2u) header += size(header);
  return v_[header].color;
}

}  // namespace spanline
