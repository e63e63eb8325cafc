#include "core/curve/dice.hpp"

namespace spanline {
namespace {

// The number of steps that all curves between four control curves of a patch can do with: the first and the last of
// them, and those that halving the patch between them leaves, which are nearer to it than the inner two.
std::uint32_t steps_between(CurveBend (&c)[4], const DiceView& view) {
  Bend most = c[0].bend();
  most.widen(c[3].bend());
  Bend all = most;
  all.widen(c[1].bend());
  all.widen(c[2].bend());
  const std::uint32_t least = most.steps(view);
  if (all.steps(view) == least) return least;
  for (int curves = 3; curves > 0; --curves) {  // de Casteljau
    for (int i = 0; i < curves; ++i) c[i].go_halfway(c[i + 1]);
    most.widen(c[0].bend());
    if (curves > 1) most.widen(c[curves - 1].bend());
  }
  return most.steps(view);
}

// Either direction of a patch.
struct Direction {
  const ClipPatch& patch;
  const ScreenPlace* places;
  const PlaceBounds& bounds;
  int stride, next;  // from point to point of a curve, and from curve to curve
  CurveReach reach[4];

  Direction(const ClipPatch& p, const ScreenPlace* place, const PlaceBounds& all, int from_point, int from_curve)
      : patch(p), places(place), bounds(all), stride(from_point), next(from_curve) {
    for (int i = 0; i < 4; ++i) reach[i] = CurveReach(first_of(i), stride);
  }
  const ClipPoint* first_of(int curve) const { return &patch.at[0][0] + curve * next; }
  CurveReach whole() const {
    CurveReach all = reach[0];
    for (const CurveReach& r : reach) all.widen(r);
    return all;
  }
  // Of the first or the last curve, by itself: as curve_steps().
  // Not inline: what it keeps is off the stack again when inner curves are looked at.
  [[gnu::noinline]] PatchSide side(int curve, const DiceView& view) const {
    const PlaceBounds own(places + curve * next, 4, stride, view);
    const CurveReach& r = reach[curve];
    const std::uint32_t steps = CurveBend(first_of(curve), stride, r, own, r.beyond_27_bits(), view).bend().steps(view);
    return {steps, r.scale(steps)};
  }
  std::uint32_t steps(int down, const DiceView& view) const {
    const auto bend = [&](int i) { return CurveBend(first_of(i), stride, reach[i], bounds, down, view); };
    CurveBend bends[4] = {bend(0), bend(1), bend(2), bend(3)};
    return steps_between(bends, view);
  }
};

std::uint32_t most(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t ab = a > b ? a : b;
  return ab > c ? ab : c;
}

}  // namespace

PatchDicer::PatchDicer(const ClipPatch& patch, const DiceView& view) : patch_(&patch) {
  ScreenPlace places[16];
  for (int i = 0; i < 16; ++i) places[i] = ScreenPlace(patch.at[i / 4][i % 4], view);
  find_steps(places, view);
}

PatchDicer::PatchDicer(const ClipPatch& patch, const ScreenXY (&projected)[4][4], const DiceView& view)
    : patch_(&patch) {
  ScreenPlace places[16];
  for (int i = 0; i < 16; ++i) places[i] = ScreenPlace(projected[i / 4][i % 4], view);
  find_steps(places, view);
}

void PatchDicer::find_steps(const ScreenPlace (&places)[16], const DiceView& view) {
  const PlaceBounds bounds(places, 16, 1, view);
  const Direction along(*patch_, places, bounds, 1, 4), across(*patch_, places, bounds, 4, 1);
  const CurveReach whole = along.whole();
  const int down = whole.beyond_27_bits();
  first_ = along.side(0, view);
  last_ = along.side(3, view);
  left_ = across.side(0, view);
  right_ = across.side(3, view);
  columns_ = most(along.steps(down, view), first_.own, last_.own);
  rows_ = most(across.steps(down, view), left_.own, right_.own);
  inner_ = {whole.scale(columns_), whole.scale(rows_)};
}

void PatchDicer::next_row(GridRow& row) {
  CHECK(row_ <= rows_);
  const auto& p = patch_->at;
  const CurveParameter here(row_, rows_);  // gives the control points themselves at both ends
  here.of_columns(p, inner_.across, row.control);
  const auto side = [&](const PatchSide& s, int j) {
    if (s.own == rows_ && s.scale == inner_.across) return row.control[j];
    const CurveParameter own(side_vertex(row_, s.own, rows_), s.own);
    return own.of(p[0][j], p[1][j], p[2][j], p[3][j], s.scale);
  };
  row.left = side(left_, 0);
  row.right = side(right_, 3);
  row.own = row_ == 0 ? first_ : row_ == rows_ ? last_ : PatchSide{};
  ++row_;
}

namespace {

// The points of a curve but its ends, a coordinate at a time, so that what is stepped stays in registers.
template <typename Int>
void step_between(const ClipPoint (&p)[4], const PatchSide& side, ClipPoint* out) {
  const typename ScaledAxis<Int>::Scale scale{kCubes[side.own], side.scale.down};
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
