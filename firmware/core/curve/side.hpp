// Curves of a patch in clip space, at any whole number of steps.
#pragma once

#include <cstdint>

#include "core/base/check.hpp"
#include "core/curve/steps.hpp"

namespace spanline {

// t = index / steps: of the point there of any number of curves. n^3 * B(i / n) is a sum with weights that add up to
// n^3.
class CurveParameter {
 public:
  // index <= steps, 1 <= steps <= kMaxSteps.
  CurveParameter(std::uint32_t index, std::uint32_t steps);
  // The point of the curve with these control points that its walk steps to.
  ClipPoint of(const ClipPoint& p0, const ClipPoint& p1, const ClipPoint& p2, const ClipPoint& p3,
               const CurveScale& scale) const {
    if (weight_[3] == 0) return p0;
    if (weight_[0] == 0) return p3;
    return scale.is_short ? blend<std::int32_t>(p0, p1, p2, p3, scale.down)
                          : blend<std::int64_t>(p0, p1, p2, p3, scale.down);
  }

 private:
  template <typename Int>
  ClipPoint blend(const ClipPoint& p0, const ClipPoint& p1, const ClipPoint& p2, const ClipPoint& p3, int down) const {
    const typename ScaledAxis<Int>::Scale scale(steps_, down);
    const auto at = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
      return ScaledAxis<Int>::weighted(a, b, c, d, weight_, scale);
    };
    return {at(p0.x, p1.x, p2.x, p3.x), at(p0.y, p1.y, p2.y, p3.y), at(p0.w, p1.w, p2.w, p3.w)};
  }

  std::int32_t weight_[4];
  std::uint32_t steps_;
};
inline ClipPoint curve_point(const ClipPoint (&p)[4], std::uint32_t index, std::uint32_t steps) {
  return CurveParameter(index, steps).of(p[0], p[1], p[2], p[3], CurveReach(p).scale(steps));
}

// A point that is stepped along a curve, and is what CurveParameter has it as. Int: as the curve's CurveScale says.
template <typename Int>
class PointWalk {
 public:
  using Scale = typename ScaledAxis<Int>::Scale;

  PointWalk() = default;
  PointWalk(const ClipPoint& p0, const ClipPoint& p1, const ClipPoint& p2, const ClipPoint& p3, std::uint32_t steps,
            int down)
      : x_(p0.x, p1.x, p2.x, p3.x, steps, down),
        y_(p0.y, p1.y, p2.y, p3.y, steps, down),
        w_(p0.w, p1.w, p2.w, p3.w, steps, down) {}

  // Not at the curve's ends.
  ClipPoint at(const Scale& scale) const { return {x_.at(scale), y_.at(scale), w_.at(scale)}; }
  void step() {
    x_.step();
    y_.step();
    w_.step();
  }

 private:
  ScaledAxis<Int> x_, y_, w_;
};

// Steps off the points of a curve at t = i / n (scaled.hpp), so that each is the same number seen from either end.
template <typename Int>
class SideWalk {
 public:
  SideWalk() = default;
  SideWalk(const ClipPoint (&p)[4], std::uint32_t steps, int down = 0)
      : walk_(p[0], p[1], p[2], p[3], steps, down), scale_(steps, down), first_(p[0]), last_(p[3]), steps_(steps) {
    CHECK(steps >= 1 && steps <= kMaxSteps);
  }

  // The current point; the control point itself at both ends. In 64 bits within 2 units of the exact one in each
  // coordinate, in 32 bits within 1.5 * 2^down.
  ClipPoint at() const { return index_ == 0 ? first_ : index_ == steps_ ? last_ : between(); }
  // Likewise, but not at the ends.
  ClipPoint between() const { return walk_.at(scale_); }
  void step() {
    CHECK(index_ < steps_);
    ++index_;
    walk_.step();
  }
  std::uint32_t steps() const { return steps_; }

 private:
  // No difference is above 24 n^3 times a coordinate's range of 2^32.
  static_assert(std::int64_t{24} * kMaxSteps * kMaxSteps * kMaxSteps <= INT64_MAX >> 32);

  PointWalk<Int> walk_;
  typename PointWalk<Int>::Scale scale_;
  ClipPoint first_{}, last_{};
  std::uint32_t steps_ = 1;
  std::uint32_t index_ = 0;
};

// Hands walk(SideWalk&) the one that is for the curve.
template <typename Walk>
void with_walk(const ClipPoint (&p)[4], std::uint32_t steps, const CurveScale& scale, Walk&& walk) {
  if (scale.is_short) {
    SideWalk<std::int32_t> by_words(p, steps, scale.down);
    walk(by_words);
  } else {
    SideWalk<std::int64_t> by_pairs(p, steps);
    walk(by_pairs);
  }
}

// A side of a patch as its grid sees it: grid vertex i of `grid` is vertex floor((2 i own + grid) / (2 grid)) of the
// side's own `own` <= grid ones. So each own chord is used once, whatever the grid, and the neighbour uses the same.
constexpr std::uint32_t side_vertex(std::uint32_t i, std::uint32_t own, std::uint32_t grid) {
  return (2 * i * own + grid) / (2 * grid);
}

// Hands the vertices of a side in this way to vertex(const ClipPoint&); `walk` is the side's own.
template <typename Walk, typename Vertex>
void step_side_off(Walk& walk, std::uint32_t grid, Vertex& vertex) {
  std::uint32_t turn = grid;
  for (std::uint32_t i = 0; i <= grid; ++i) {
    vertex(walk.at());
    turn += 2 * walk.steps();
    if (turn < 2 * grid || i == grid) continue;
    turn -= 2 * grid;
    walk.step();
  }
}

}  // namespace spanline
