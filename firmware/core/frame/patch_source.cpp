#include "core/frame/patch_source.hpp"

#include <bit>

#include "core/geom/clip.hpp"
#include "core/shade/facet_light.hpp"

namespace spanline {

namespace {

// A normal on its way through the clipper, which mixes colours.
Rgb8 as_color(const Normal10& n) {
  const auto channel = [](std::int32_t v) { return static_cast<std::uint8_t>((v >> 2) + 128); };
  return {channel(n.x()), channel(n.y()), channel(n.z())};
}
Normal10 as_normal(const Rgb8& c) { return Normal10::pack((c.r - 128) * 4, (c.g - 128) * 4, (c.b - 128) * 4); }

}  // namespace

// A row of the grid; stepped off only where a strip beside it may be seen.
struct PatchSource::Row {
  std::uint16_t scratch = 0;  // where its vertices stand while it is worked at
  GridRow grid{};
  std::uint32_t index = 0;
  ScreenBounds bounds{};
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
  PatchJob job(reader, look, {top_, bottom_, screen_.width});
  if (job.nothing) return true;
  PatchDicer dicer = job.make_dicer(DiceView(reader.camera(), screen_, p_.tolerance));
  job.dicer = &dicer;
  const PatchTangents tangents = job.tangents_of_corners();
  job.tangents = &tangents;
  const std::uint32_t two_rows = 2 * (dicer.columns() + 1), all = p_.vertices.capacity();
  if (used_ + two_rows > all) {
    lacks_vertices(used_ + two_rows - all);
    return false;
  }
  return dice_rows(job) && shortage_.pool == nullptr;
}

bool PatchSource::dice_rows(PatchJob& job) {
  Row rows[2];
  rows[0].scratch = static_cast<std::uint16_t>(p_.vertices.capacity() - job.columns());
  rows[1].scratch = static_cast<std::uint16_t>(rows[0].scratch - job.columns() - 1);
  for (std::uint32_t i = 0; i <= job.rows(); ++i) {
    Row& above = rows[(i + 1) % 2];
    Row& below = rows[i % 2];
    below = {.scratch = below.scratch, .index = i};
    job.dicer->next_row(below.grid);
    below.bounds = job.bounds_of(below.grid);
    if (i == 0) continue;
    ScreenBounds both = above.bounds;
    both.widen(below.bounds);
    if (!job.behind && !job.window.meets(both)) continue;
    step_off(job, above);
    step_off(job, below);
    if (!strip(job, above, below)) return false;
  }
  return true;
}

void PatchSource::step_off(const PatchJob& job, Row& row) {
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

// Whether the facet covers something of the band.
bool PatchSource::reaches(const PatchJob& job, const DicedFacet& facet) const {
  ScreenBounds bounds;
  for (std::uint32_t i = 0; i < corner_count(facet); ++i) bounds.widen(p_.vertices[corner(facet, i)].at);
  return job.window.meets(bounds);
}

bool PatchSource::seen_clipped(const PatchJob& job, const DicedFacet& facet) const {
  return reaches(job, facet) && (job.look.two_sided || front(facet, job.reader.mirrored()));
}

// The facets between two rows: first those inside of all planes, then those that some plane cuts.
bool PatchSource::strip(const PatchJob& job, Row& above, Row& below) {
  Parts whole;
  std::uint64_t cut = 0;
  for (std::uint32_t i = 0; i < job.columns(); ++i) {
    const DicedFacet cell = facet_at(above, above.scratch, below.scratch, i);
    std::uint32_t any = 0, all = 0xff;
    for (std::uint32_t c = 0; job.outside && c < 4; ++c) {
      const std::uint32_t code = p_.vertices[corner(cell, c)].outcode;
      any |= code;
      all &= code;
    }
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (any == 0) note_parts(job, cell, bit, whole);
    if (any != 0 && all == 0) cut |= bit;
  }
  const auto first_facet = static_cast<std::uint16_t>(count_ + 1);
  if (whole.any() != 0 && !add_whole(job, above, below, whole)) return false;
  for (; cut != 0; cut &= cut - 1) {
    if (!add_cut(job, above, below, static_cast<std::uint32_t>(std::countr_zero(cut)))) return false;
  }
  if (!job.look.gouraud) colour(job, above, below, first_facet);
  return true;
}

// Which facets the cell has that are seen.
void PatchSource::note_parts(const PatchJob& job, DicedFacet cell, std::uint64_t bit, Parts& whole) const {
  if (!reaches(job, cell)) return;
  const auto at = [&](std::uint32_t i) { return PackedXY(p_.vertices[corner(cell, i)].at); };
  const std::uint8_t parts = CellParts::of(at(0), at(1), at(2), at(3), job.reader.mirrored(), job.look.two_sided);
  if (parts == CellParts::kQuad) {
    whole.quads |= bit;
    return;
  }
  const auto part_reaches = [&](DicedFacet::Kind kind) {
    cell.kind = kind & 3u;
    return reaches(job, cell);
  };
  if ((parts & CellParts::kUpper) != 0 && part_reaches(DicedFacet::kUpper)) whole.upper |= bit;
  if ((parts & CellParts::kLower) != 0 && part_reaches(DicedFacet::kLower)) whole.lower |= bit;
}

DicedFacet PatchSource::facet_at(const Row& above, std::uint16_t above_at, std::uint16_t below_at,
                                 std::uint32_t column) {
  DicedFacet facet{};
  facet.above = static_cast<std::uint16_t>(above_at + column);
  facet.below = static_cast<std::uint16_t>(below_at + column);
  facet.part = (above.index * kMaxSteps + column) * 2 & 0x1fffu;
  return facet;
}
static_assert(kMaxSteps <= 64, "columns are bits of a word, parts are 13 bits");

bool PatchSource::add_whole(const PatchJob& job, Row& above, Row& below, const Parts& parts) {
  std::uint64_t columns = parts.any();
  const auto first = static_cast<std::uint32_t>(std::countr_zero(columns));
  const auto end = static_cast<std::uint32_t>(64 - std::countl_zero(columns));
  if (!keep_row(job, above, first, end + 1) || !keep_row(job, below, first, end + 1)) return false;
  const auto at = [](const Row& row) { return static_cast<std::uint16_t>(row.kept - row.kept_first); };
  for (; columns != 0; columns &= columns - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(columns));
    const std::uint64_t bit = columns & ~(columns - 1);
    DicedFacet facet = facet_at(above, at(above), at(below), i);
    if ((parts.quads & bit) != 0 && !add(facet)) return false;
    facet.kind = DicedFacet::kUpper;
    if ((parts.upper & bit) != 0 && !add(facet)) return false;
    facet.kind = DicedFacet::kLower;
    facet.part |= 1u;
    if ((parts.lower & bit) != 0 && !add(facet)) return false;
  }
  return true;
}

// Copies the row's vertices [first, end) to where they stay, unless they stand there already.
bool PatchSource::keep_row(const PatchJob& job, Row& row, std::uint32_t first, std::uint32_t end) {
  if (row.kept_first <= first && end <= row.kept_end) return true;
  row.kept_first = first;
  row.kept_end = end;
  row.kept = static_cast<std::uint16_t>(used_ + 1);
  if (!take_vertices(job, end - first)) return lacks_vertices(end - first);
  for (std::uint32_t i = first; i < end; ++i) p_.vertices[row.kept + i - first] = p_.vertices[row.scratch + i];
  if (job.look.gouraud) {
    const NormalRow normals(*job.tangents, row.index);
    for (std::uint32_t i = first; i < end; ++i) p_.normals[row.kept + i - first] = normals.at(i);
  }
  return true;
}

// False where there are not so many in front of the patch's two rows in the making, or some facet lacked room before.
bool PatchSource::take_vertices(const PatchJob& job, std::uint32_t count) {
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
bool PatchSource::add_cut(const PatchJob& job, const Row& above, const Row& below, std::uint32_t column) {
  DicedFacet facet = facet_at(above, 0, 0, column);
  facet.above = static_cast<std::uint16_t>(used_ + 1);
  facet.kind = DicedFacet::kClipped;
  const std::uint32_t corners = clip(job, above, below, column);
  const std::uint32_t end = used_ + corners + 2 * (job.columns() + 1);
  if (end > p_.vertices.capacity()) return lacks_vertices(corners);
  facet.below = static_cast<std::uint16_t>(corners);
  if (corners < 3 || !seen_clipped(job, facet)) return true;
  return take_vertices(job, corners) ? add(facet) : lacks_vertices(corners);
}

// Writes the corners of the clipped facet behind the vertices in use, those that there is room for; returns how many.
std::uint32_t PatchSource::clip(const PatchJob& job, const Row& above, const Row& below, std::uint32_t column) {
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
void PatchSource::take_corners(const PatchJob& job, const Row& row, std::uint32_t column, ClipVertex& a,
                               ClipVertex& b) {
  std::uint32_t i = 0;
  job.dicer->step_off(row.grid, [&](const ClipPoint& p) {
    if (i == column) a.at = p;
    if (i == column + 1) b.at = p;
    ++i;
  });
  if (!job.look.gouraud) return;
  const NormalRow normals(*job.tangents, row.index);
  a.color = as_color(normals.at(column));
  b.color = as_color(normals.at(column + 1));
}

// Lights the facets from `first` on, of the strip between the rows; their corners are stepped to again.
void PatchSource::colour(const PatchJob& job, const Row& above, const Row& below, std::uint16_t first) {
  if (first > count_) return;
  const FacetLight light(*job.look.lights, job.reader.matrix(), job.reader.mirrored());
  const FacetLight::Of of(light, *job.look.material, job.look.format, job.dicer->near());
  for (std::uint32_t i = first; i <= count_; ++i) {
    DicedFacet& facet = p_.facets[i];
    const std::uint32_t column = facet.part / 2u % kMaxSteps;
    const auto vertex = [&](const Row& row, std::uint32_t at) { return job.dicer->vertex(row.grid, at); };
    const bool flip = job.look.two_sided && !shows_front(facet, job.reader.mirrored());
    facet.payload = of.payload(vertex(above, column), vertex(above, column + 1), vertex(below, column + 1),
                               vertex(below, column), flip);
  }
}

std::int32_t PatchSource::first_line(const DicedFacet& facet) const {
  std::int32_t top = ScreenBounds::kFar;
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

// Whether its cell does, or what the view leaves of that.
bool PatchSource::shows_front(DicedFacet facet, bool mirrored) const {
  if (facet.kind != DicedFacet::kClipped) facet.kind = DicedFacet::kQuad;
  return front(facet, mirrored);
}

}  // namespace spanline
