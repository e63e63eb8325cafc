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

  rows_ = 1;
  CurveReach whole;
  for (int j = 0; j < 4; ++j) {
    Curve column;
    take_column(patch, j, column);
    const std::uint32_t own = curve_steps(column, view);
    const CurveReach reach(column);
    rows_ = most(rows_, own);
    whole.widen(reach);
    if (j == 0) left_ = {own, reach.scale(own)};
    if (j == 3) right_ = {own, reach.scale(own)};
  }
  inner_ = {whole.scale(columns_), whole.scale(rows_)};
}

GridRow PatchDicer::next_row() {
  CHECK(row_ <= rows_);
  const auto& p = patch_->at;
  const CurveParameter here(row_, rows_);  // gives the control points themselves at both ends
  const auto column = [&](const CurveParameter& at, int j, const CurveScale& scale) {
    return at.of(p[0][j], p[1][j], p[2][j], p[3][j], scale);
  };
  const auto side = [&](const Side& s, int j) {
    if (s.own == rows_) return column(here, j, s.scale);
    return column(CurveParameter(side_vertex(row_, s.own, rows_), s.own), j, s.scale);
  };
  GridRow row;
  for (int j = 0; j < 4; ++j) row.control[j] = column(here, j, inner_.across);
  row.left = side(left_, 0);
  row.right = side(right_, 3);
  if (row_ == 0) row.own = own_first_;
  if (row_ == rows_) row.own = own_last_;
  ++row_;
  return row;
}

}  // namespace spanline
