#include "core/frame/patch_job.hpp"

namespace spanline {

namespace {

// Turns a patch's grid by a quarter; its front stays the front.
template <typename T>
void turn(T (&at)[4][4]) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const T first = at[i][j];
      at[i][j] = at[j][3 - i];
      at[j][3 - i] = at[3 - i][3 - j];
      at[3 - i][3 - j] = at[3 - j][i];
      at[3 - j][i] = first;
    }
  }
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
  reader.control_points(patch.at);
  const Projection projection = reader.projection();
  for (const auto& row : patch.at) {
    for (const ClipPoint& p : row) well_inside = well_inside && projection.well_inside(p);
  }
  if (well_inside) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) at[i][j] = projection(patch.at[i][j]).at;
    }
  } else {
    project_held();
  }
  PackedBox points;
  for (const auto& row : at) {
    for (const ScreenXY& p : row) points.widen(PackedXY(p));
  }
  bounds = ScreenBounds(points).of_hull();
  nothing = nothing || !(behind || window.meets(bounds));
  if (nothing) return;
  whole = !outside && window.holds(bounds);
  // Strips are to be thin from top to bottom, so that a band meets few of them.
  turned = is_steep(at);
  if (!turned) return;
  turn(patch.at);
  turn(at);
}

// Where some control point may lie outside of the view.
void PatchJob::project_held() {
  const Projection& projection = reader.projection();
  std::uint8_t outside_any = 0, outside_all = 0xff;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const ClipPoint& p = patch.at[i][j];
      const std::uint8_t code = projection.outcode(p);
      outside_any |= code;
      outside_all &= code;
      at[i][j] = (code & Outcode::kNear) != 0 ? kNotProjected : projection.clamped(p).at;
    }
  }
  behind = (outside_any & Outcode::kNear) != 0;
  outside = outside_any != 0;
  nothing = outside_all != 0;
}

PatchTangents PatchJob::tangents_of_corners() const {
  PatchShape shape;
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (std::uint32_t j = 0; j < 4; ++j) {  // as turn() has it
      shape.at[i][j] = reader.mesh().positions[reader.face().corners[turned ? 4 * j + 3 - i : 4 * i + j]];
    }
  }
  return {shape, {rows(), columns()}};
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
