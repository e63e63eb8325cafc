#include "core/frame/patch_job.hpp"

namespace spanline {

namespace {

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

}  // namespace

PatchJob::PatchJob(const FacetReader& facets, const PatchLook& patch_look, const PatchWindow& w)
    : reader(facets), look(patch_look), window(w) {
  const Projection& projection = reader.projection();
  std::uint8_t outside_any = 0, outside_all = 0xff;
  ScreenXY at[4][4];
  ScreenBounds points;
  for (std::uint32_t i = 0; i < 16; ++i) {
    ClipPoint& p = patch.at[i / 4][i % 4];
    ClipPoint inside = p = reader.control_point(i);
    std::uint8_t code = 0;
    if (!projection.well_inside(p)) {
      well_inside = false;
      code = projection.outcode(p);
      if (code != 0) inside = projection.held(p);
    }
    outside_any |= code;
    outside_all &= code;
    points.widen(at[i / 4][i % 4] = projection(inside).at);
  }
  bounds = points.of_hull();
  behind = (outside_any & Outcode::kNear) != 0;
  outside = outside_any != 0;
  nothing = outside_all != 0 || !(behind || window.meets(bounds));
  if (nothing) return;
  whole = !outside && window.holds(bounds);
  for (std::uint32_t i = 0; i < 16; ++i) {
    shape.at[i / 4][i % 4] = reader.mesh().positions[reader.face().corners[i]];
  }
  // Strips are to be thin from top to bottom, so that a band meets few of them.
  if (!is_steep(at)) return;
  turn(patch.at);
  turn(shape.at);
}

ScreenBounds PatchJob::bounds_of(const GridRow& row) const {
  if (behind) return ScreenBounds::anywhere();
  ScreenBounds b;
  for (const ClipPoint& p : row.control) b.widen(reader.projection().clamped(p).at);
  b.widen(reader.projection().clamped(row.left).at);
  b.widen(reader.projection().clamped(row.right).at);
  return b.of_hull();
}

}  // namespace spanline
