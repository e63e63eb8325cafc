// Of PatchGrids, what Gouraud's shading takes.
#include "core/frame/patch_grids.hpp"

namespace spanline {

// Gives the vertices of drawn cells their brightness; the grid begins with row `row` of the patch.
void PatchGrids::light(const PatchJob& job, std::uint32_t header, std::uint32_t row) {
  const PatchTangents tangents = job.tangents_of_corners();
  const std::uint32_t stride = v_[header].stride, end = header + size(header);
  for (std::uint32_t first = header + 1; first != end; first += stride, ++row) {
    std::uint32_t column = 0;
    while (column != stride && !has_cell(first + column, stride)) ++column;
    if (column != stride) light_row(*job.look.lights, tangents, first, column, row);
  }
}

// Those of the patch's row `row`, which begins at `first`, from `column` on. Not inline: the tangents are made before
// there is a row of normals on the stack.
[[gnu::noinline]] void PatchGrids::light_row(const LightRig& rig, const PatchTangents& tangents, std::uint32_t first,
                                             std::uint32_t column, std::uint32_t row) {
  const bool single = rig.single();
  const LightRig::One one = single ? rig.one() : LightRig::One{};
  const NormalRow normals(tangents, row);
  const std::uint32_t stride = v_[first].stride;
  for (; column != stride; ++column) {
    if (!has_cell(first + column, stride)) continue;
    const Normal10 normal = normals.at(column);
    v_[first + column].color = single ? LightRig::brightness(one.sum(normal)) : rig.brightness(normal, false);
  }
}

BrightnessPlane PatchGrids::brightness(FaceId face) const {
  const GridVertex* corner[4];
  const std::uint32_t count = corners(face, corner);
  ScreenXY at[4];
  Brightness level[4]{};
  for (std::uint32_t i = 0; i != count; ++i) {
    at[i] = corner[i]->at;
    level[i] = static_cast<Brightness>(corner[i]->color);
  }
  return count == 4 ? cell_brightness(at, level)
                    : brightness_plane({at[0], at[1], at[2]}, {level[0], level[1], level[2]});
}

}  // namespace spanline
