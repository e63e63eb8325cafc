// The exact predicates against their definitions, on grids small enough to try everything.
#include "core/area/predicates.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "core/area/plane.hpp"

namespace spanline::area::test {
namespace {

constexpr GridPoint at(int x, int y) { return {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)}; }

// A bound on a segment's parameter, as a fraction, and whether the bound itself is in.
struct Bound {
  int number, divisor;
  bool in;
};

// The half-open pixel by its definition: some parameter 0 … 1 with -1 <= coordinate < 1, in half units from the centre.
bool passes_by_definition(GridPoint a, GridPoint b, GridPoint centre) {
  Bound low{0, 1, true}, high{1, 1, true};
  const auto raise = [&](Bound to) {
    const int order = to.number * low.divisor - low.number * to.divisor;
    if (order > 0 || (order == 0 && !to.in)) low = to;
  };
  const auto lower = [&](Bound to) {
    const int order = to.number * high.divisor - high.number * to.divisor;
    if (order < 0 || (order == 0 && !to.in)) high = to;
  };
  const int from[2] = {2 * (a.x - centre.x), 2 * (a.y - centre.y)}, by[2] = {2 * (b.x - a.x), 2 * (b.y - a.y)};
  for (int axis = 0; axis < 2; ++axis) {
    if (by[axis] == 0) {
      if (from[axis] < -1 || from[axis] >= 1) return false;
    } else if (by[axis] > 0) {
      raise({-1 - from[axis], by[axis], true});
      lower({1 - from[axis], by[axis], false});
    } else {
      raise({from[axis] - 1, -by[axis], false});
      lower({from[axis] + 1, -by[axis], true});
    }
  }
  const int order = low.number * high.divisor - high.number * low.divisor;
  return order < 0 || (order == 0 && low.in && high.in);
}

TEST(Predicates, APixelIsClosedToTheLeftAndBelow) {
  constexpr int kReach = 4;
  for (int ax = -kReach; ax <= kReach; ++ax) {
    for (int ay = -kReach; ay <= kReach; ++ay) {
      for (int bx = -kReach; bx <= kReach; ++bx) {
        for (int by = -kReach; by <= kReach; ++by) {
          if (ax == bx && ay == by) continue;
          for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
              ASSERT_EQ(passes_pixel(at(ax, ay), at(bx, by), at(x, y)),
                        passes_by_definition(at(ax, ay), at(bx, by), at(x, y)))
                  << ax << "," << ay << " " << bx << "," << by << " " << x << "," << y;
            }
          }
        }
      }
    }
  }
}

TEST(Predicates, ACrossingIsRoundedOnce) {
  const Crossing whole = crossing(at(0, 0), at(4, 4), at(0, 4), at(4, 0));
  EXPECT_TRUE(whole.found && !whole.rounded && whole.at == at(2, 2));
  const Crossing half = crossing(at(0, 0), at(1, 1), at(0, 1), at(1, 0));
  EXPECT_TRUE(half.found && half.rounded && half.at == at(1, 1));
  const Crossing below = crossing(at(0, 0), at(-1, -1), at(0, -1), at(-1, 0));
  EXPECT_TRUE(below.found && below.rounded && below.at == at(0, 0));
  EXPECT_FALSE(crossing(at(0, 0), at(4, 0), at(2, 0), at(2, 5)).found) << "an end on the edge is a vertex already";
  EXPECT_FALSE(crossing(at(0, 0), at(4, 0), at(1, 0), at(9, 0)).found) << "an overlap";
}

TEST(Predicates, ACrossingLiesInThePixelsThatBothPass) {
  constexpr int kReach = 3;
  for (int i = 0; i < 7 * 7 * 7 * 7; ++i) {
    const GridPoint a = at(i % 7 - kReach, i / 7 % 7 - kReach), b = at(i / 49 % 7 - kReach, i / 343 - kReach);
    for (const auto& [c, d] : {std::pair{at(-3, -1), at(3, 2)}, {at(-2, 3), at(1, -3)}, {at(0, -3), at(0, 3)}}) {
      const Crossing found = crossing(a, b, c, d);
      if (!found.found) continue;
      EXPECT_TRUE(passes_pixel(a, b, found.at) && passes_pixel(c, d, found.at));
      EXPECT_EQ(found.rounded, orientation(a, b, found.at) != 0 || orientation(c, d, found.at) != 0);
    }
  }
}

TEST(Predicates, TheWholeRangeIsExact) {
  constexpr int m = kMaxCoordinate;
  EXPECT_EQ(orientation(at(-m, -m), at(m, -m), at(m, m)), std::int64_t{4} * m * m);
  const Crossing centre = crossing(at(-m, -m), at(m, m), at(-m, m), at(m, -m));
  EXPECT_TRUE(centre.found && !centre.rounded && centre.at == at(0, 0));
  const Crossing beside = crossing(at(-m, -m), at(m, m - 1), at(-m, m), at(m, -m));
  EXPECT_TRUE(beside.found && beside.rounded && beside.at == at(0, 0));
}

TEST(Predicates, DepthGoesOnInItsPlane) {
  constexpr Plane kPlane = Plane::through({at(0, 0), at(10, 0), at(0, 10)}, {100, 200, 65535});
  static_assert(kPlane.depth(at(5, 0)) == 150);
  static_assert(kPlane.depth(at(20, 0)) == 300);
  static_assert(kPlane.depth(at(0, 10)) == 65535);
  constexpr Plane kReversed = Plane::through({at(0, 10), at(10, 0), at(0, 0)}, {65535, 200, 100});
  for (int x = -30; x < 30; ++x) EXPECT_EQ(kPlane.depth(at(x, 7 - x)), kReversed.depth(at(x, 7 - x)));
  constexpr int m = kMaxCoordinate;
  constexpr Plane kWide = Plane::through({at(-m, -m), at(m, -m), at(m, m)}, {0, kMaxDepth, 0});
  EXPECT_EQ(kWide.depth(at(m, -m)), kMaxDepth);
  EXPECT_EQ(kWide.depth(at(-m, m)), -kMaxDepth);
  // Hardly seen from the side: the gradient is cut off, and values stay within 64 bits.
  constexpr Plane kSteep = Plane::through({at(-m, -m), at(m, m - 1), at(m - 1, m - 2)}, {0, kMaxDepth, 0});
  EXPECT_EQ(kSteep.along_x, -kMaxGradient);
  EXPECT_LT(kSteep.value(at(m, -m)) - kSteep.value(at(-m, m)), INT64_MAX / 4);
}

}  // namespace
}  // namespace spanline::area::test
