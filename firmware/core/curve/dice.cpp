#include "core/curve/dice.hpp"

namespace spanline {
namespace {

using Curve = ClipPoint[4];

void take_column(const ClipPatch& patch, int j, Curve& column) {
  for (int i = 0; i < 4; ++i) column[i] = patch.at[i][j];
}

std::uint32_t most(std::uint32_t a, std::uint32_t b) { return a > b ? a : b; }

}  // namespace

PatchDicer::PatchDicer(const ClipPatch& patch, const DiceView& view) : patch_(&patch) {
  own_first_ = curve_steps(patch.at[0], view);
  own_last_ = curve_steps(patch.at[3], view);
  columns_ = most(most(own_first_, own_last_), most(curve_steps(patch.at[1], view), curve_steps(patch.at[2], view)));

  Curve column[4];
  std::uint32_t own[4];
  rows_ = 1;
  for (int j = 0; j < 4; ++j) {
    take_column(patch, j, column[j]);
    own[j] = curve_steps(column[j], view);
    rows_ = most(rows_, own[j]);
  }
  left_ = GridSide(column[0], own[0], rows_);
  right_ = GridSide(column[3], own[3], rows_);
  for (int j = 0; j < 4; ++j) controls_[j] = SideWalk(column[j], rows_);
}

GridRow PatchDicer::next_row() {
  CHECK(row_ <= rows_);
  GridRow row;
  for (int j = 0; j < 4; ++j) row.control[j] = controls_[j].at();  // the control points themselves at both ends
  row.left = left_.at();
  row.right = right_.at();
  if (row_ == 0) row.own = own_first_;
  if (row_ == rows_) row.own = own_last_;
  if (++row_ <= rows_) {
    left_.step();
    right_.step();
    for (SideWalk& column : controls_) column.step();
  }
  return row;
}

}  // namespace spanline
