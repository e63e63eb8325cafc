// Every point of every walk equals the exact fraction: not nearly, equal.
#include "core/curve/basis.hpp"

#include <gtest/gtest.h>

#include "oracle/curve_exact.hpp"
#include "oracle/random.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

enum class Move { halve, double_step, step };

// A place on the dyadic grid of one direction: t = at / 2^kFinest, steps of 2^-level.
template <int kFinest>
struct Place {
  int at = 0;
  int level = kFirstLevel;

  int length() const { return 1 << (kFinest - level); }
  bool done() const { return at == 1 << kFinest; }
  bool allows(Move move) const {
    switch (move) {
      case Move::halve:
        return level < kFinest;
      case Move::double_step:  // from a multiple of the longer step, so that no step passes the end
        return level > kFirstLevel && at % (2 * length()) == 0;
      default:
        return true;
    }
  }
  void take(Move move) {
    if (move == Move::halve) ++level;
    if (move == Move::double_step) --level;
    if (move == Move::step) at += length();
  }
};

Move any_move(Random& random) {
  const int one = random.below(8);
  return one < 3 ? Move::halve : one < 5 ? Move::double_step : Move::step;
}

// Control points over the whole range, its very ends included (the widest differences come from those).
template <int kBits>
int any_coordinate(Random& random) {
  constexpr int kMost = 1 << (kBits - 1);
  if (random.percent(20)) return random.percent(50) ? kMost : -kMost;
  return random.between(-kMost, kMost);
}

template <typename Int, int kBits, int kFinest>
void walk_curves(std::uint64_t first_seed, int walks) {
  using Format = CurveFormat<Int, kBits, kFinest>;
  for (int walk = 0; walk < walks; ++walk) {
    Random random(first_seed + static_cast<std::uint64_t>(walk));
    Int p[4];
    std::int64_t exact[4];
    for (int i = 0; i < 4; ++i) exact[i] = p[i] = any_coordinate<kBits>(random);
    CurveBasis<Int> basis = Format::start(p);
    Place<kFinest> place;
    while (!place.done()) {
      const Move move = any_move(random);
      if (!place.allows(move)) continue;
      place.take(move);
      if (move == Move::halve) basis.halve();
      if (move == Move::double_step) basis.double_step();
      if (move == Move::step) basis.step();
      ASSERT_EQ(basis.b0.value(), oracle::exact_cubic(exact, place.at, 1 << kFinest)) << "walk " << walk;
    }
    ASSERT_EQ(basis.b0.value(), exact[3] << Format::kFraction) << "walk " << walk;
  }
}

TEST(ForwardDifferences, AMillionWalksAreExactIn32Bits) {
  walk_curves<std::int32_t, 9 + 4, 6>(1, oracle::rounds(1'000'000));
}
TEST(ForwardDifferences, FinerSubpixelsAndWiderScreensAreExact) {
  walk_curves<std::int32_t, 9 + 8, 4>(2, oracle::rounds(100'000));
  walk_curves<std::int32_t, 10 + 4, 5>(3, oracle::rounds(100'000));
  walk_curves<std::int64_t, 18, 15>(4, 20);  // 2^15 steps each; the format that strands are walked in
}

template <int kBits, int kFinestU, int kFinestV>
void walk_surfaces(std::uint64_t first_seed, int walks) {
  using Format = SurfaceFormat<std::int64_t, kBits, kFinestU, kFinestV>;
  for (int walk = 0; walk < walks; ++walk) {
    Random random(first_seed + static_cast<std::uint64_t>(walk));
    std::int64_t p[4][4];
    for (auto& row : p) {
      for (std::int64_t& point : row) point = any_coordinate<kBits>(random);
    }
    auto basis = Format::start(p);
    Place<kFinestU> u;
    Place<kFinestV> v;
    for (int move_count = 0; move_count < 200 && !(u.done() && v.done()); ++move_count) {
      const Move move = any_move(random);
      if (random.percent(50)) {
        if (u.done() || !u.allows(move)) continue;
        u.take(move);
        if (move == Move::halve) basis.halve();
        if (move == Move::double_step) basis.double_step();
        if (move == Move::step) basis.step();
      } else {
        if (v.done() || !v.allows(move)) continue;
        v.take(move);
        if (move == Move::halve) halve_inner(basis);
        if (move == Move::double_step) double_inner(basis);
        if (move == Move::step) step_inner(basis);
      }
      ASSERT_EQ(basis.b0.b0.value(), oracle::exact_bicubic(p, u.at, 1 << kFinestU, v.at, 1 << kFinestV))
          << "walk " << walk;
    }
  }
}

TEST(ForwardDifferences, SurfaceWalksAreExactIn64Bits) {
  walk_surfaces<9 + 4, 8, 8>(10, oracle::rounds(20'000));
  walk_surfaces<9 + 4, 6, 10>(11, oracle::rounds(20'000));
  walk_surfaces<9 + 8, 7, 8>(12, oracle::rounds(20'000));
  walk_surfaces<10 + 4, 12, 4>(13, oracle::rounds(20'000));
}

TEST(ForwardDifferences, DoublingUndoesHalving) {
  Random random(20);
  for (int i = 0; i < oracle::rounds(10'000); ++i) {
    const std::int32_t p[4] = {any_coordinate<13>(random), any_coordinate<13>(random), any_coordinate<13>(random),
                               any_coordinate<13>(random)};
    const auto start = CurveFormat<std::int32_t, 13, 6>::start(p);
    auto basis = start;
    for (int level = kFirstLevel; level < 6; ++level) basis.halve();
    for (int level = kFirstLevel; level < 6; ++level) basis.double_step();
    ASSERT_EQ(basis, start);
  }
}

TEST(ForwardDifferences, TheHalvesOfASplitMeetInTheSameInteger) {
  Random random(30);
  for (int i = 0; i < oracle::rounds(10'000); ++i) {
    const std::int32_t p[4] = {any_coordinate<13>(random), any_coordinate<13>(random), any_coordinate<13>(random),
                               any_coordinate<13>(random)};
    auto whole = CurveFormat<std::int32_t, 13, 6>::start(p);  // its first quarter is one step long
    auto end = whole;
    end.step();
    auto left = whole;
    auto right = left.split();
    auto left_end = left;
    left_end.step();
    ASSERT_EQ(left.b0, whole.b0);
    ASSERT_EQ(left_end.b0, right.b0);
    right.step();
    ASSERT_EQ(right.b0, end.b0);
  }
}

TEST(ForwardDifferences, NeighboursThatShareAnEndMeetThereFromBothSides) {
  Random random(40);
  for (int i = 0; i < oracle::rounds(10'000); ++i) {
    std::int32_t a[4], b[4];
    for (std::int32_t& point : a) point = any_coordinate<13>(random);
    for (std::int32_t& point : b) point = any_coordinate<13>(random);
    b[0] = a[3];
    auto first = CurveFormat<std::int32_t, 13, 6>::start(a);
    const auto second = CurveFormat<std::int32_t, 13, 6>::start(b);
    for (int step = 0; step < 1 << kFirstLevel; ++step) first.step();
    ASSERT_EQ(first.b0, second.b0);
  }
}

}  // namespace
}  // namespace spanline::test
