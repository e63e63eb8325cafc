// Curves of a patch in clip space, at any whole number of steps.
#pragma once

#include <cstdint>

#include "core/curve/basis.hpp"
#include "core/geom/projection.hpp"

namespace spanline {

// Most steps of a curve. A curve that would need more (a patch that fills the screen many times over) is stepped that
// often and no more: its chords are then coarser than asked for, on both sides of a joint alike.
inline constexpr std::uint32_t kMaxSteps = 64;

// What the number of steps depends on, beside the curve's own four control points. All patches that share a boundary
// must be given the same.
struct DiceView {
  std::int32_t near_w;      // Q16.16
  std::int32_t reach;       // Q16.16 guard bands: half the longer side of the screen
  std::uint32_t tolerance;  // 1/16 px that a chord may be off its curve; at least 1

  DiceView(const Projection& projection, const Screen& screen, std::uint32_t tolerance_16ths)
      : near_w(projection.near_w),
        reach((screen.width > screen.height ? screen.width : screen.height) * (0x10000 / 2 / kGuardPx)),
        tolerance(tolerance_16ths) {}
};

// How many equal steps in t bring the curve's chords on the screen within the tolerance: 1 … kMaxSteps. The same for
// the curve run backwards.
std::uint32_t curve_steps(const ClipPoint (&p)[4], const DiceView& view);

// t = index / steps: of the point there of any number of curves. n^3 * B(i / n) is a sum with weights that add up to
// n^3.
class CurveParameter {
 public:
  // index <= steps, 1 <= steps <= kMaxSteps.
  CurveParameter(std::uint32_t index, std::uint32_t steps);
  // The point of the curve with these control points that SideWalk steps to.
  ClipPoint of(const ClipPoint& p0, const ClipPoint& p1, const ClipPoint& p2, const ClipPoint& p3) const;

 private:
  std::int32_t weight_[4];
  std::uint32_t steps_;
};
inline ClipPoint curve_point(const ClipPoint (&p)[4], std::uint32_t index, std::uint32_t steps) {
  return CurveParameter(index, steps).of(p[0], p[1], p[2], p[3]);
}

// Steps off the points of a curve at t = i / n exactly: the registers hold n^3 times the coordinate, an integer, so
// that the point is the same number seen from either end. What comes out is rounded once, by a rule that sees that
// number and n only.
class SideWalk {
 public:
  SideWalk() = default;
  SideWalk(const ClipPoint (&p)[4], std::uint32_t steps);

  // The current point; the control point itself at both ends. Within 2 units of the exact one in each coordinate.
  ClipPoint at() const;
  void step();
  std::uint32_t steps() const { return steps_; }

 private:
  // No difference is above 24 n^3 times a coordinate's range of 2^32.
  static_assert(std::int64_t{24} * kMaxSteps * kMaxSteps * kMaxSteps <= INT64_MAX >> 32);

  CurveBasis<std::int64_t> x_, y_, w_;
  ClipPoint first_{}, last_{};
  std::uint32_t steps_ = 1;
  std::uint32_t index_ = 0;
};

// A side of a patch as its grid sees it: grid vertex i of `grid` is vertex floor((2 i own + grid) / (2 grid)) of the
// side's own `own` <= grid ones. So each own chord is used once, whatever the grid, and the neighbour uses the same.
constexpr std::uint32_t side_vertex(std::uint32_t i, std::uint32_t own, std::uint32_t grid) {
  return (2 * i * own + grid) / (2 * grid);
}

// Steps a side off in this way.
class GridSide {
 public:
  GridSide() = default;
  GridSide(const ClipPoint (&p)[4], std::uint32_t own, std::uint32_t grid) : walk_(p, own), grid_(grid), turn_(grid) {}

  ClipPoint at() const { return walk_.at(); }

  // To the next grid vertex.
  void step() {
    turn_ += 2 * walk_.steps();
    if (turn_ < 2 * grid_) return;
    turn_ -= 2 * grid_;
    walk_.step();
  }

 private:
  SideWalk walk_;
  std::uint32_t grid_ = 1;
  std::uint32_t turn_ = 1;
};

}  // namespace spanline
