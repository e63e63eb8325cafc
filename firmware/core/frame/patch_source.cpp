#include "core/frame/patch_source.hpp"

#include <bit>

#include "core/geom/clip.hpp"
#include "core/shade/pixel.hpp"

namespace spanline {

namespace {

constexpr std::int32_t kFar = 1 << 16;  // 28.4, off every screen

// What something covers at most, 28.4.
struct Bounds {
  std::int32_t top = kFar, bottom = -kFar, left = kFar, right = -kFar;

  void widen(const Bounds& other) {
    if (other.top < top) top = other.top;
    if (other.bottom > bottom) bottom = other.bottom;
    if (other.left < left) left = other.left;
    if (other.right > right) right = other.right;
  }
  void widen(ScreenXY p) { widen({p.y, p.y, p.x, p.x}); }
  // Rounding may put a vertex so far out of the hull of the control points.
  void widen_hull(ScreenXY p) { widen({p.y - 2, p.y + 2, p.x - 2, p.x + 2}); }
};
constexpr Bounds kAnywhere{-kFar, kFar, -kFar, kFar};

// What is worked for: lines of a band, columns of the screen.
struct Window {
  std::int32_t top, bottom, width;

  // Whether the centre of a pixel of it may be covered.
  bool meets(const Bounds& b) const {
    const std::int32_t first = first_centre(b.top), end = first_centre(b.bottom);
    const std::int32_t left = first_centre(b.left), right = first_centre(b.right);
    return first < end && first < bottom && end > top && left < right && left < width && right > 0;
  }
};

// Turns a patch's grid by a quarter; its front stays the front.
template <typename T>
void turn(T (&at)[4][4]) {
  T before[4][4];
  for (int i = 0; i < 16; ++i) before[i / 4][i % 4] = at[i / 4][i % 4];
  for (int i = 0; i < 16; ++i) at[i / 4][i % 4] = before[i % 4][3 - i / 4];
}

std::int32_t distance(std::int32_t a, std::int32_t b) { return a < b ? b - a : a - b; }

// Whether the rows of the grid run more steeply on the screen than its columns.
bool is_steep(const ScreenXY (&at)[4][4]) {
  std::int32_t along = 0, across = 0;
  for (int i = 0; i < 4; ++i) {
    along += distance(at[i][0].y, at[i][3].y);
    across += distance(at[0][i].y, at[3][i].y);
  }
  return along > across;
}

// A normal on its way through the clipper, which mixes colours.
Rgb8 as_color(const Normal10& n) {
  const auto channel = [](std::int32_t v) { return static_cast<std::uint8_t>((v >> 2) + 128); };
  return {channel(n.x()), channel(n.y()), channel(n.z())};
}
Normal10 as_normal(const Rgb8& c) { return Normal10::pack((c.r - 128) * 4, (c.g - 128) * 4, (c.b - 128) * 4); }

}  // namespace

// A patch at work.
struct PatchSource::Job {
  const FacetReader& reader;
  const PatchLook& look;
  Window window;
  ClipPatch patch;
  PatchShape shape;
  Bounds bounds;
  bool behind = false;   // some control point lies before the near plane: its bounds say nothing
  bool outside = false;  // some control point lies outside of some plane
  bool nothing = false;  // nothing of the patch can be seen
  PatchDicer* dicer = nullptr;

  Job(const FacetReader& facets, const PatchLook& patch_look, const Window& w);
  std::uint32_t rows() const { return dicer->rows(); }
  std::uint32_t columns() const { return dicer->columns(); }
  Bounds bounds_of(const GridRow& row) const;
};

PatchSource::Job::Job(const FacetReader& facets, const PatchLook& patch_look, const Window& w)
    : reader(facets), look(patch_look), window(w) {
  const Projection& projection = reader.projection();
  std::uint8_t outside_any = 0, outside_all = 0xff;
  ScreenXY at[4][4];
  for (std::uint32_t i = 0; i < 16; ++i) {
    const ClipPoint p = reader.control_point(i);
    const std::uint8_t code = projection.outcode(p);
    outside_any |= code;
    outside_all &= code;
    patch.at[i / 4][i % 4] = p;
    bounds.widen_hull(at[i / 4][i % 4] = projection.clamped(p).at);
  }
  behind = (outside_any & Outcode::kNear) != 0;
  outside = outside_any != 0;
  nothing = outside_all != 0 || !(behind || window.meets(bounds));
  if (nothing) return;
  for (std::uint32_t i = 0; i < 16; ++i) {
    shape.at[i / 4][i % 4] = reader.mesh().positions[reader.face().corners[i]];
  }
  // Strips are to be thin from top to bottom, so that a band meets few of them.
  if (!is_steep(at)) return;
  turn(patch.at);
  turn(shape.at);
}

Bounds PatchSource::Job::bounds_of(const GridRow& row) const {
  if (behind) return kAnywhere;
  Bounds b;
  for (const ClipPoint& p : row.control) b.widen_hull(reader.projection().clamped(p).at);
  b.widen_hull(reader.projection().clamped(row.left).at);
  b.widen_hull(reader.projection().clamped(row.right).at);
  return b;
}

// A row of the grid; stepped off only where a strip beside it may be seen.
struct PatchSource::Row {
  std::uint16_t scratch = 0;  // where its vertices stand while it is worked at
  GridRow grid{};
  std::uint32_t index = 0;
  Bounds bounds{};
  bool stepped = false;
  std::uint16_t kept = 0;  // where the vertices [kept_first, kept_end) stand for good; 0: nowhere
  std::uint32_t kept_first = 0, kept_end = 0;
};

void PatchSource::begin_band(std::int32_t top, std::int32_t bottom) {
  top_ = top;
  bottom_ = bottom;
  count_ = used_ = 0;
  shortage_ = {};
}

// Counts what there is no room for. False where there is no use in going on.
bool PatchSource::lacks(const Shortage& pool, std::uint32_t count) {
  if (shortage_.pool == nullptr) shortage_ = pool;
  if (shortage_.pool == pool.pool) shortage_.needed += count;
  return bottom_ - top_ == 1;
}
bool PatchSource::lacks_facet() {
  const std::uint32_t all = p_.facets.capacity();
  return lacks({"patch_facets", all, all}, 1);
}
bool PatchSource::lacks_vertices(std::uint32_t count) {
  const std::uint32_t all = p_.vertices.capacity();
  return lacks({"patch_vertices", all, all}, count);
}

bool PatchSource::dice(const FacetReader& reader, const PatchLook& look) {
  Job job(reader, look, {top_, bottom_, screen_.width});
  if (job.nothing) return true;
  PatchDicer dicer(job.patch, DiceView(reader.projection(), screen_, p_.tolerance));
  job.dicer = &dicer;
  const std::uint32_t two_rows = 2 * (dicer.columns() + 1), all = p_.vertices.capacity();
  if (used_ + two_rows > all) {
    lacks_vertices(used_ + two_rows - all);
    return false;
  }
  return dice_rows(job) && shortage_.pool == nullptr;
}

bool PatchSource::dice_rows(Job& job) {
  Row rows[2];
  rows[0].scratch = static_cast<std::uint16_t>(p_.vertices.capacity() - job.columns());
  rows[1].scratch = static_cast<std::uint16_t>(rows[0].scratch - job.columns() - 1);
  for (std::uint32_t i = 0; i <= job.rows(); ++i) {
    Row& above = rows[(i + 1) % 2];
    Row& below = rows[i % 2];
    const GridRow grid = job.dicer->next_row();
    below = {.scratch = below.scratch, .grid = grid, .index = i, .bounds = job.bounds_of(grid)};
    if (i == 0) continue;
    Bounds both = above.bounds;
    both.widen(below.bounds);
    if (!job.behind && !job.window.meets(both)) continue;
    step_off(job, above);
    step_off(job, below);
    if (!strip(job, above, below)) return false;
  }
  return true;
}

void PatchSource::step_off(const Job& job, Row& row) {
  if (row.stepped) return;
  row.stepped = true;
  points_ += job.columns() + 1;
  const Projection& projection = job.reader.projection();
  std::size_t at = row.scratch;
  job.dicer->step_off(row.grid, [&](const ClipPoint& p) {
    ScreenPoint& out = p_.vertices[at++];
    out = projection.clamped(p);
    if (job.outside) out.outcode = projection.outcode(p);
  });
}

bool PatchSource::seen(const Job& job, const DicedFacet& facet) const {
  Bounds bounds;
  for (std::uint32_t i = 0; i < corner_count(facet); ++i) bounds.widen(p_.vertices[corner(facet, i)].at);
  return job.window.meets(bounds) && (job.look.two_sided || front(facet, job.reader.mirrored()));
}

// The facets between two rows: first those inside of all planes, then those that some plane cuts.
bool PatchSource::strip(const Job& job, Row& above, Row& below) {
  std::uint64_t whole = 0, cut = 0;
  for (std::uint32_t i = 0; i < job.columns(); ++i) {
    const DicedFacet facet = facet_at(above, above.scratch, below.scratch, i);
    std::uint32_t any = 0, all = 0xff;
    for (std::uint32_t c = 0; job.outside && c < 4; ++c) {
      const std::uint32_t code = p_.vertices[corner(facet, c)].outcode;
      any |= code;
      all &= code;
    }
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (any == 0 && seen(job, facet)) whole |= bit;
    if (any != 0 && all == 0) cut |= bit;
  }
  const auto first_facet = static_cast<std::uint16_t>(count_ + 1);
  if (whole != 0 && !add_whole(job, above, below, whole)) return false;
  for (; cut != 0; cut &= cut - 1) {
    if (!add_cut(job, above, below, static_cast<std::uint32_t>(std::countr_zero(cut)))) return false;
  }
  if (!job.look.gouraud) colour(job, above.index, first_facet);
  return true;
}

DicedFacet PatchSource::facet_at(const Row& above, std::uint16_t above_at, std::uint16_t below_at,
                                 std::uint32_t column) {
  DicedFacet facet{};
  facet.above = static_cast<std::uint16_t>(above_at + column);
  facet.below = static_cast<std::uint16_t>(below_at + column) & 0x7fffu;
  facet.part = static_cast<std::uint16_t>(above.index * kMaxSteps + column);
  return facet;
}
static_assert(kMaxSteps <= 64, "columns are bits of a word, parts are 16 bits");

bool PatchSource::add_whole(const Job& job, Row& above, Row& below, std::uint64_t columns) {
  const auto first = static_cast<std::uint32_t>(std::countr_zero(columns));
  const auto end = static_cast<std::uint32_t>(64 - std::countl_zero(columns));
  if (!keep_row(job, above, first, end + 1) || !keep_row(job, below, first, end + 1)) return false;
  for (; columns != 0; columns &= columns - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(columns));
    const auto at = [](const Row& row) { return static_cast<std::uint16_t>(row.kept - row.kept_first); };
    if (!add(facet_at(above, at(above), at(below), i))) return false;
  }
  return true;
}

// Copies the row's vertices [first, end) to where they stay, unless they stand there already.
bool PatchSource::keep_row(const Job& job, Row& row, std::uint32_t first, std::uint32_t end) {
  if (row.kept_first <= first && end <= row.kept_end) return true;
  row.kept_first = first;
  row.kept_end = end;
  row.kept = static_cast<std::uint16_t>(used_ + 1);
  if (!take_vertices(job, end - first)) return lacks_vertices(end - first);
  for (std::uint32_t i = first; i < end; ++i) p_.vertices[row.kept + i - first] = p_.vertices[row.scratch + i];
  if (job.look.gouraud) {
    const NormalRow normals(job.shape, row.index, {job.rows(), job.columns()});
    for (std::uint32_t i = first; i < end; ++i) p_.normals[row.kept + i - first] = normals.at(i);
  }
  return true;
}

// False where there are not so many in front of the patch's two rows in the making, or some facet lacked room before.
bool PatchSource::take_vertices(const Job& job, std::uint32_t count) {
  const std::uint32_t end = used_ + count + 2 * (job.columns() + 1);
  if (shortage_.pool != nullptr || end > p_.vertices.capacity()) return false;
  used_ = static_cast<std::uint16_t>(used_ + count);
  if (end > most_vertices_) most_vertices_ = static_cast<std::uint16_t>(end);
  return true;
}

bool PatchSource::add(const DicedFacet& facet) {
  if (shortage_.pool != nullptr || count_ == p_.facets.capacity()) return lacks_facet();
  p_.facets[++count_] = facet;
  if (count_ > most_facets_) most_facets_ = count_;
  return true;
}

// Clips a facet and adds what is left of it.
bool PatchSource::add_cut(const Job& job, const Row& above, const Row& below, std::uint32_t column) {
  DicedFacet facet = facet_at(above, 0, 0, column);
  facet.above = static_cast<std::uint16_t>(used_ + 1);
  facet.clipped = 1;
  const std::uint32_t corners = clip(job, above, below, column);
  const std::uint32_t end = used_ + corners + 2 * (job.columns() + 1);
  if (end > p_.vertices.capacity()) return lacks_vertices(corners);
  facet.below = corners & 0x7fffu;
  if (corners < 3 || !seen(job, facet)) return true;
  return take_vertices(job, corners) ? add(facet) : lacks_vertices(corners);
}

// Writes the corners of the clipped facet behind the vertices in use, those that there is room for; returns how many.
std::uint32_t PatchSource::clip(const Job& job, const Row& above, const Row& below, std::uint32_t column) {
  const Projection& projection = job.reader.projection();
  ClipVertex corners[4];
  take_corners(job, above, column, corners[0], corners[1]);
  take_corners(job, below, column, corners[3], corners[2]);
  std::uint8_t planes = 0;
  for (const ClipVertex& v : corners) planes |= projection.outcode(v.at);
  ContourClipper clipper(projection, planes);
  std::uint32_t count = 0;
  ClipVertex out;
  for (int i = 0; i <= 4; ++i) {
    if (i < 4) {
      clipper.feed(corners[i]);
    } else {
      clipper.finish();
    }
    while (clipper.next(out)) {
      const std::uint32_t at = used_ + ++count;
      if (at + 2 * (job.columns() + 1) > p_.vertices.capacity()) continue;
      p_.vertices[at] = projection.clamped(out.at);
      if (job.look.gouraud) p_.normals[at] = as_normal(out.color);
    }
  }
  return count;
}

// The row's vertices `column` and the next: clipping is rare, so they are not kept but stepped to again.
void PatchSource::take_corners(const Job& job, const Row& row, std::uint32_t column, ClipVertex& a, ClipVertex& b) {
  std::uint32_t i = 0;
  job.dicer->step_off(row.grid, [&](const ClipPoint& p) {
    if (i == column) a.at = p;
    if (i == column + 1) b.at = p;
    ++i;
  });
  if (!job.look.gouraud) return;
  const NormalRow normals(job.shape, row.index, {job.rows(), job.columns()});
  a.color = as_color(normals.at(column));
  b.color = as_color(normals.at(column + 1));
}

// Lights the facets from `first` on, of the strip below row `row`, by the normals at their middles.
void PatchSource::colour(const Job& job, std::uint32_t row, std::uint16_t first) {
  if (first > count_) return;
  const NormalRow normals(job.shape, 2 * row + 1, {2 * job.rows(), 2 * job.columns()});
  for (std::uint32_t i = first; i <= count_; ++i) {
    DicedFacet& facet = p_.facets[i];
    const Normal10 normal = normals.at(2 * (facet.part % kMaxSteps) + 1);
    const bool flip = job.look.two_sided && !front(facet, job.reader.mirrored());
    facet.payload = flat_payload(job.look.format, job.look.lights->shade(normal, *job.look.material, flip));
  }
}

std::int32_t PatchSource::first_line(const DicedFacet& facet) const {
  std::int32_t top = kFar;
  for (std::uint32_t i = 0; i < corner_count(facet); ++i) {
    const std::int32_t y = p_.vertices[corner(facet, i)].at.y;
    if (y < top) top = y;
  }
  return first_centre(top);
}

bool PatchSource::front(const DicedFacet& facet, bool mirrored) const {
  std::int64_t area = 0;  // doubled; y points down, so fronts have it negative
  ScreenXY before = p_.vertices[corner(facet, corner_count(facet) - 1)].at;
  for (std::uint32_t i = 0; i < corner_count(facet); ++i) {
    const ScreenXY at = p_.vertices[corner(facet, i)].at;
    area += std::int64_t{before.x} * at.y - std::int64_t{at.x} * before.y;
    before = at;
  }
  return (mirrored ? -area : area) < 0;
}

}  // namespace spanline
