#include "core/curve/dice.hpp"

namespace spanline {
namespace {

using Curve = ClipPoint[4];

void take_column(const ClipPatch& patch, int j, Curve& column) {
  for (int i = 0; i < 4; ++i) column[i] = patch.at[i][j];
}

std::uint32_t most(std::uint32_t a, std::uint32_t b) { return a > b ? a : b; }

void step_off(GridSide side, Slice<ClipPoint> row, std::uint32_t steps) {
  row[0] = side.at();
  for (std::uint32_t i = 1; i <= steps; ++i) {
    side.step();
    row[i] = side.at();
  }
}

}  // namespace

PatchDicer::PatchDicer(const ClipPatch& patch, const DiceView& view) : patch_(patch) {
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

void PatchDicer::next_row(Slice<ClipPoint> row) {
  CHECK(row_ <= rows_ && row.size() > columns_);
  if (row_ != 0) {
    left_.step();
    right_.step();
    for (SideWalk& column : controls_) column.step();
  }
  if (row_ == 0) {
    step_off(GridSide(patch_.at[0], own_first_, columns_), row, columns_);
  } else if (row_ == rows_) {
    step_off(GridSide(patch_.at[3], own_last_, columns_), row, columns_);
  } else {
    inner_row(row);
  }
  ++row_;
}

void PatchDicer::inner_row(Slice<ClipPoint> row) const {
  const Curve control = {controls_[0].at(), controls_[1].at(), controls_[2].at(), controls_[3].at()};
  SideWalk walk(control, columns_);
  row[0] = left_.at();
  for (std::uint32_t i = 1; i < columns_; ++i) {
    walk.step();
    row[i] = walk.at();
  }
  row[columns_] = right_.at();
}

}  // namespace spanline
