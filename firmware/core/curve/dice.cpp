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

  std::uint32_t own[4];
  rows_ = 1;
  for (int j = 0; j < 4; ++j) {
    Curve column;
    take_column(patch, j, column);
    own[j] = curve_steps(column, view);
    rows_ = most(rows_, own[j]);
  }
  own_left_ = own[0];
  own_right_ = own[3];
}

GridRow PatchDicer::next_row() {
  CHECK(row_ <= rows_);
  GridRow row;
  const auto& p = patch_->at;
  const CurveParameter here(row_, rows_);  // gives the control points themselves at both ends
  for (int j = 0; j < 4; ++j) row.control[j] = here.of(p[0][j], p[1][j], p[2][j], p[3][j]);
  const auto side = [&](int j, std::uint32_t own) {
    if (own == rows_) return row.control[j];
    return CurveParameter(side_vertex(row_, own, rows_), own).of(p[0][j], p[1][j], p[2][j], p[3][j]);
  };
  row.left = side(0, own_left_);
  row.right = side(3, own_right_);
  if (row_ == 0) row.own = own_first_;
  if (row_ == rows_) row.own = own_last_;
  ++row_;
  return row;
}

}  // namespace spanline
