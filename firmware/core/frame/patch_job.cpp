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
  for (const ClipPoint& p : row.control) b.widen_hull(reader.projection().clamped(p).at);
  b.widen_hull(reader.projection().clamped(row.left).at);
  b.widen_hull(reader.projection().clamped(row.right).at);
  return b;
}

std::uint8_t CellParts::of(ScreenXY a, ScreenXY b, ScreenXY c, ScreenXY d, bool mirrored, bool two_sided) {
  // Doubled, negative for fronts; a b c + a c d = a b d + b c d.
  std::int32_t abc = doubled_area(a, b, c), acd = doubled_area(a, c, d), abd = doubled_area(a, b, d);
  if (mirrored) {
    abc = -abc;
    acd = -acd;
    abd = -abd;
  }
  const auto bcd = static_cast<std::int32_t>(static_cast<std::uint32_t>(abc) + static_cast<std::uint32_t>(acd) -
                                             static_cast<std::uint32_t>(abd));
  if ((abc | acd | abd | bcd) == 0) return kNone;
  const auto part = [&](bool upper, bool lower) {
    return static_cast<std::uint8_t>((upper ? kUpper : 0) | (lower ? kLower : 0) | kApart);
  };
  if (abc <= 0 && acd <= 0 && abd <= 0 && bcd <= 0) return kQuad;
  if (two_sided) {
    if (abc >= 0 && acd >= 0 && abd >= 0 && bcd >= 0) return kQuad;
    return part(abc != 0, acd != 0);
  }
  return abc < 0 || acd < 0 ? part(abc < 0, acd < 0) : std::uint8_t{kNone};
}

}  // namespace spanline
