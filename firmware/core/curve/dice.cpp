#include "core/curve/dice.hpp"

#include "core/curve/seen_curve.hpp"
#include "core/fx/length.hpp"

namespace spanline {
namespace {

// A quarter of the way from the first to the last of four.
ClipPoint quarter_way(const ClipPoint& a, const ClipPoint& b, const ClipPoint& c, const ClipPoint& d) {
  const auto blend = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
    return static_cast<std::int32_t>(sum_quarter_way(p, q, r, s) >> kQuarterBits);
  };
  return {blend(a.x, b.x, c.x, d.x), blend(a.y, b.y, c.y, d.y), blend(a.w, b.w, c.w, d.w)};
}

// Either direction of a patch.
struct Direction {
  const ClipPatch& patch;
  const ScreenXY (&places)[4][4];
  int stride, next;  // from point to point of a curve, and from curve to curve

  const ClipPoint* first_of(int curve) const { return &patch.at[0][0] + curve * next; }
  const ScreenXY* place_of(int curve) const { return &places[0][0] + curve * next; }
  SeenCurve seen(int curve) const { return {first_of(curve), place_of(curve), stride}; }

  // Of the first or the last curve, by itself: as curve_steps(). Widens what reaches are passed.
  PatchSide side(int curve, std::uint32_t square_of_steps, CurveReach& all) const {
    const CurveReach reach(first_of(curve), stride);
    all.widen(reach);
    const std::uint32_t steps = steps_of(square_of_steps);
    return {steps, reach.scale(steps)};
  }
  PatchSide side(int curve, const DiceView& view, CurveReach& all) const {
    return side(curve, square_of_steps(first_of(curve), place_of(curve), stride, view), all);
  }
  // Of the curves a quarter of the way from either side, and both sides', where SeenCurve is for them; `cut`: as
  // SeenPlaces says.
  [[gnu::noinline]] std::uint32_t steps(const DiceView& view, int cut, PatchSide& first_side, PatchSide& last_side,
                                        CurveReach& all) const {
    const SeenCurve first = seen(0), second = seen(1), third = seen(2), last = seen(3);
    first_side = side(0, first.square_of_steps(view), all);
    last_side = side(3, last.square_of_steps(view), all);
    return steps_of(larger(SeenCurve::quarter_way(first, second, third, last, cut).square_of_steps(view),
                           SeenCurve::quarter_way(last, third, second, first, cut).square_of_steps(view)));
  }
  // Of the same two, where it is not.
  [[gnu::noinline]] std::uint32_t steps_at_most(const PlaceBounds& bounds, int down, const DiceView& view) const {
    std::uint32_t square = 0;
    for (const bool last : {false, true}) {
      ClipPoint between[4];
      for (int i = 0; i < 4; ++i) {
        const ClipPoint* const p = first_of(last ? 3 : 0) + i * stride;
        const int to = last ? -next : next;
        between[i] = quarter_way(p[0], p[to], p[2 * to], p[3 * to]);
      }
      square = larger(square, square_of_steps_at_most(between, 1, bounds, down, view));
    }
    return steps_of(square);
  }
};

}  // namespace

PatchDicer::PatchDicer(const ClipPatch& patch, const DiceView& view) : patch_(&patch) {
  ScreenXY places[4][4];
  for (int i = 0; i < 16; ++i) places[i / 4][i % 4] = place_on_screen(patch.at[i / 4][i % 4], view);
  find_steps(places, view);
}

PatchDicer::PatchDicer(const ClipPatch& patch, const ScreenXY (&projected)[4][4], const DiceView& view)
    : patch_(&patch) {
  find_steps(projected, view);
}

void PatchDicer::find_steps(const ScreenXY (&places)[4][4], const DiceView& view) {
  const Direction along{*patch_, places, 1, 4}, across{*patch_, places, 4, 1};
  SeenPlaces seen;
  for (int i = 0; i < 16; ++i) seen.widen(places[i / 4][i % 4], patch_->at[i / 4][i % 4].w);
  CurveReach whole;
  for (int i = 1; i < 3; ++i) {
    for (int j = 1; j < 3; ++j) whole.widen(patch_->at[i][j]);
  }
  if (seen.allow(view)) {
    columns_ = along.steps(view, seen.cut(), first_, last_, whole);
    rows_ = across.steps(view, seen.cut(), left_, right_, whole);
  } else {
    first_ = along.side(0, view, whole);
    last_ = along.side(3, view, whole);
    left_ = across.side(0, view, whole);
    right_ = across.side(3, view, whole);
    const PlaceBounds bounds(seen.places, view);
    columns_ = along.steps_at_most(bounds, whole.beyond_27_bits(), view);
    rows_ = across.steps_at_most(bounds, whole.beyond_27_bits(), view);
  }
  columns_ = larger(columns_, larger(first_.own, last_.own));
  rows_ = larger(rows_, larger(left_.own, right_.own));
  inner_ = {whole.scale(columns_), whole.scale(rows_)};
  const auto start = [this](int j, std::uint32_t steps, const CurveScale& scale, PointWalk<std::int32_t>& walk) {
    const auto& p = patch_->at;
    if (scale.is_short) walk = {p[0][j], p[1][j], p[2][j], p[3][j], steps, scale.down};
  };
  for (int j = 0; j < 4; ++j) start(j, rows_, inner_.across, control_[j]);
  if (!is_column(left_)) start(0, left_.own, left_.scale, end_[0]);
  if (!is_column(right_)) start(3, right_.own, right_.scale, end_[1]);
}

void PatchDicer::next_row(GridRow& row) {
  CHECK(row_ <= rows_);
  const auto& p = patch_->at;
  if (row_ == 0 || row_ == rows_) {
    for (int j = 0; j < 4; ++j) row.control[j] = p[row_ == 0 ? 0 : 3][j];
  } else if (inner_.across.is_short) {
    const PointWalk<std::int32_t>::Scale scale(rows_, inner_.across.down);
    for (int j = 0; j < 4; ++j) {
      control_[j].step();
      row.control[j] = control_[j].at(scale);
    }
  } else {
    const CurveParameter here(row_, rows_);
    for (int j = 0; j < 4; ++j) row.control[j] = here.of(p[0][j], p[1][j], p[2][j], p[3][j], inner_.across);
  }
  row.left = is_column(left_) ? row.control[0] : end_of_row(left_, 0, end_[0]);
  row.right = is_column(right_) ? row.control[3] : end_of_row(right_, 3, end_[1]);
  row.own = row_ == 0 ? first_ : row_ == rows_ ? last_ : PatchSide{};
  ++row_;
}

ClipPoint PatchDicer::end_of_row(const PatchSide& side, int j, PointWalk<std::int32_t>& walk) const {
  const auto& p = patch_->at;
  const std::uint32_t at = side_vertex(row_, side.own, rows_);
  if (at == 0 || at == side.own) return p[at == 0 ? 0 : 3][j];
  if (!side.scale.is_short) return CurveParameter(at, side.own).of(p[0][j], p[1][j], p[2][j], p[3][j], side.scale);
  if (side_vertex(row_ - 1, side.own, rows_) != at) walk.step();
  return walk.at({side.own, side.scale.down});
}

namespace {

// The points of a curve but its ends, a coordinate at a time, so that what is stepped stays in registers.
template <typename Int>
void step_between(const ClipPoint (&p)[4], const PatchSide& side, ClipPoint* out) {
  const typename ScaledAxis<Int>::Scale scale(side.own, side.scale.down);
  for (std::int32_t ClipPoint::*const axis : {&ClipPoint::x, &ClipPoint::y, &ClipPoint::w}) {
    ScaledAxis<Int> walk(p[0].*axis, p[1].*axis, p[2].*axis, p[3].*axis, side.own, side.scale.down);
    for (std::uint32_t i = 1; i < side.own; ++i) {
      walk.step();
      out[i].*axis = walk.at(scale);
    }
  }
}

}  // namespace

void PatchDicer::step_off(const GridRow& row, ClipPoint* out) const {
  const bool is_side = row.own.own != 0;
  const PatchSide side = is_side ? row.own : PatchSide{columns_, inner_.along};
  out[0] = is_side ? row.control[0] : row.left;
  out[side.own] = is_side ? row.control[3] : row.right;
  if (side.scale.is_short) {
    step_between<std::int32_t>(row.control, side, out);
  } else {
    step_between<std::int64_t>(row.control, side, out);
  }
  if (side.own == columns_) return;
  // In place from the last one on: what is taken stands before where it goes.
  for (std::uint32_t i = columns_; i > 0; --i) out[i] = out[side_vertex(i, side.own, columns_)];
}

ClipPoint PatchDicer::vertex(const GridRow& row, std::uint32_t column) const {
  const auto& p = row.control;
  if (row.own.own != 0) {
    return CurveParameter(side_vertex(column, row.own.own, columns_), row.own.own)
        .of(p[0], p[1], p[2], p[3], row.own.scale);
  }
  if (column == 0) return row.left;
  if (column == columns_) return row.right;
  return CurveParameter(column, columns_).of(p[0], p[1], p[2], p[3], inner_.along);
}

}  // namespace spanline
