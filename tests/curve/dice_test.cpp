#include "core/curve/dice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "curve/patch_scene.hpp"

namespace spanline::test {
namespace {

using Corner = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
using Edge = std::pair<Corner, Corner>;

// Edges that were added an odd number of times: where the surface ends.
class EdgeParity {
 public:
  void add(const ClipPoint& a, const ClipPoint& b) {
    const Corner p{a.x, a.y, a.w}, q{b.x, b.y, b.w};
    if (p != q) edges_.push_back(p < q ? Edge{p, q} : Edge{q, p});
  }
  std::size_t odd() {
    std::sort(edges_.begin(), edges_.end());
    std::size_t odd = 0;
    for (std::size_t i = 0; i < edges_.size();) {
      std::size_t end = i;
      while (end < edges_.size() && edges_[end] == edges_[i]) ++end;
      odd += (end - i) % 2;
      i = end;
    }
    return odd;
  }

 private:
  std::vector<Edge> edges_;
};

using SidePoints = std::array<Position, 4>;

std::array<SidePoints, 4> sides_of(const PatchPoints& p) {
  return {{{p[0][0], p[0][1], p[0][2], p[0][3]},
           {p[3][0], p[3][1], p[3][2], p[3][3]},
           {p[0][0], p[1][0], p[2][0], p[3][0]},
           {p[0][3], p[1][3], p[2][3], p[3][3]}}};
}

// The sides that an odd number of patches have: the model's own rims.
struct Sides {
  std::vector<SidePoints> rims;
  int joints = 0;
};
Sides sides_of(const std::vector<PatchPoints>& patches) {
  using Key = std::array<std::tuple<int, int, int>, 4>;
  std::map<Key, std::pair<SidePoints, int>> users;
  for (const PatchPoints& patch : patches) {
    for (const SidePoints& side : sides_of(patch)) {
      Key key;
      for (std::size_t i = 0; i < 4; ++i) key[i] = {side[i].x, side[i].y, side[i].z};
      Key back = key;
      std::reverse(back.begin(), back.end());
      auto& user = users[std::min(key, back)];
      user.first = side;
      ++user.second;
    }
  }
  Sides sides;
  for (const auto& [key, user] : users) {
    if (user.second % 2 != 0) sides.rims.push_back(user.first);
    if (user.second > 1) ++sides.joints;
  }
  return sides;
}

struct Diced {
  int facets = 0, triangles = 0;
  std::size_t cracks = 0;
};

// Dices every patch and adds up the boundary; what is left beside the rims' own chords is a crack.
Diced dice_all(const std::vector<PatchPoints>& patches, const Sides& sides, const PatchView& view) {
  Diced diced;
  EdgeParity edges;
  ClipPoint rows[2][kMaxSteps + 1];
  for (const PatchPoints& patch : patches) {
    dice(view.patch(patch), view.dice, rows[0], rows[1], [&](const PatchFacet& facet) {
      ++diced.facets;
      if (facet.count == 3) ++diced.triangles;
      for (std::uint32_t i = 0; i < facet.count; ++i) {
        edges.add(facet.corners[i], facet.corners[(i + 1) % facet.count]);
      }
    });
  }
  for (const SidePoints& rim : sides.rims) {
    const ClipPoint p[4] = {view.matrix(rim[0]), view.matrix(rim[1]), view.matrix(rim[2]), view.matrix(rim[3])};
    const std::uint32_t steps = curve_steps(p, view.dice);
    with_walk(p, steps, CurveReach(p).scale(steps), [&](auto& walk) {
      for (std::uint32_t i = 0; i < walk.steps(); ++i) {
        const ClipPoint from = walk.at();
        walk.step();
        edges.add(from, walk.at());
      }
    });
  }
  diced.cracks = edges.odd();
  return diced;
}

// From a quarter of the distance at which the model fills the screen to four times as far.
double any_distance(std::uint64_t seed) { return 0.25 * std::pow(2, static_cast<double>(seed % 41) / 10); }

TEST(Dice, TheTeapotHasNoCrackInAThousandViews) {
  const auto patches = teapot_patches();
  const Sides sides = sides_of(patches);
  EXPECT_GT(sides.joints, 40);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const PatchView view = random_view(seed, any_distance(seed), seed % 3 == 0 ? 4 : 8);
    ASSERT_EQ(dice_all(patches, sides, view).cracks, 0u) << "view " << seed;
  }
  RecordProperty("joints", 1000 * sides.joints);
}

TEST(Dice, NorHasItWhereTheNearPlaneCutsIt) {
  const auto patches = teapot_patches();
  const Sides sides = sides_of(patches);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const PatchView view = random_view(seed, 0.05 + 0.005 * static_cast<double>(seed), 8);
    ASSERT_EQ(dice_all(patches, sides, view).cracks, 0u) << "view " << seed;
  }
}

TEST(Dice, RandomNetsOfPatchesHaveNoCrack) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto patches = random_patches(seed, 3);
    const Sides sides = sides_of(patches);
    ASSERT_EQ(sides.rims.size(), 12u);
    ASSERT_EQ(sides.joints, 12);
    const PatchView view = random_view(seed, any_distance(seed), 1 + static_cast<std::uint32_t>(seed % 20));
    ASSERT_EQ(dice_all(patches, sides, view).cracks, 0u) << "net " << seed;
  }
}

TEST(Dice, TheTeapotTakesAsManyFacetsAsItsTolerance) {
  const auto patches = teapot_patches();
  const Sides sides = sides_of(patches);
  constexpr int kViews = 100;
  const auto mean_facets = [&](std::uint32_t tolerance) {
    int facets = 0;
    for (std::uint64_t seed = 0; seed < kViews; ++seed) {
      facets += dice_all(patches, sides, random_view(seed, 1, tolerance)).facets;
    }
    return facets / kViews;
  };
  const int at_one = mean_facets(16), at_half = mean_facets(8), at_quarter = mean_facets(4);
  RecordProperty("facets_at_one", at_one);
  RecordProperty("facets_at_half", at_half);
  RecordProperty("facets_at_quarter", at_quarter);
  EXPECT_LT(at_one, 600);
  EXPECT_LT(at_half, 1100);
  EXPECT_LT(at_quarter, 2100);
}

struct OnScreen {
  double x, y;  // px from the screen's centre
};
OnScreen exact_place(const ClipPoint (&p)[4], double t) {
  const double s = 1 - t;
  const double weight[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  double x = 0, y = 0, w = 0;
  for (int i = 0; i < 4; ++i) {
    x += weight[i] * p[i].x;
    y += weight[i] * p[i].y;
    w += weight[i] * p[i].w;
  }
  return {kGuardPx * x / w, kGuardPx * y / w};
}
double distance_to_chord(OnScreen p, OnScreen a, OnScreen b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

bool on_screen(OnScreen p) {
  return std::fabs(p.x) <= kPatchScreen.width / 2.0 && std::fabs(p.y) <= kPatchScreen.height / 2.0;
}

// The farthest that any visible place of a curve is from its chord, as a part of the tolerance; 0 where the near plane
// or kMaxSteps limits it.
double chord_error(const ClipPoint (&p)[4], std::uint32_t steps, const PatchView& view) {
  if (steps == kMaxSteps) return 0;
  for (const ClipPoint& point : p) {
    if (point.w < view.dice.near_w) return 0;
  }
  double worst = 0;
  constexpr int kSamples = 4;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const OnScreen a = exact_place(p, static_cast<double>(i) / steps);
    const OnScreen b = exact_place(p, static_cast<double>(i + 1) / steps);
    for (int j = 1; j < kSamples; ++j) {
      const OnScreen at = exact_place(p, (i + static_cast<double>(j) / kSamples) / steps);
      if (on_screen(at)) worst = std::max(worst, distance_to_chord(at, a, b));
    }
  }
  return worst / (view.dice.tolerance / 16.0);
}

// The worst of the curves that run through a patch from its first to its last row, or column, in the patch's own steps.
double worst_inside(const ClipPatch& patch, const PatchView& view) {
  constexpr int kCurves = 12;
  const PatchDicer dicer(patch, view.dice);
  double worst = 0;
  for (int k = 0; k <= kCurves; ++k) {
    const double t = static_cast<double>(k) / kCurves, s = 1 - t;
    const double weight[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    ClipPoint along[4], across[4];
    for (std::size_t i = 0; i < 4; ++i) {
      const auto mean = [&](std::int32_t ClipPoint::*axis, bool rows) {
        double sum = 0;
        for (std::size_t j = 0; j < 4; ++j) sum += weight[j] * (rows ? patch.at[j][i] : patch.at[i][j]).*axis;
        return static_cast<std::int32_t>(std::lround(sum));
      };
      along[i] = {mean(&ClipPoint::x, true), mean(&ClipPoint::y, true), mean(&ClipPoint::w, true)};
      across[i] = {mean(&ClipPoint::x, false), mean(&ClipPoint::y, false), mean(&ClipPoint::w, false)};
    }
    worst = std::max({worst, chord_error(along, dicer.columns(), view), chord_error(across, dicer.rows(), view)});
  }
  return worst;
}

// How far chords are from their curves, as parts of the tolerance: hardly ever by more than all of it.
class ChordErrors {
 public:
  void add(double error) {
    worst_ = std::max(worst_, error);
    beyond_ += error > 1;
    ++count_;
  }
  void check() const {
    testing::Test::RecordProperty("worst_over_tolerance", std::to_string(worst_));
    EXPECT_LE(worst_, 1.05);
    EXPECT_LE(beyond_, count_ / 1000);
    EXPECT_GT(worst_, 0.7);  // no more steps than are needed
  }

 private:
  double worst_ = 0;
  std::size_t beyond_ = 0, count_ = 0;
};

TEST(Dice, ChordsAreWithinTheTolerance) {
  const auto patches = teapot_patches();
  ChordErrors errors;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::uint32_t tolerance = seed % 2 == 0 ? 8 : 4;
    const PatchView view = random_view(seed, any_distance(seed), tolerance);
    for (const PatchPoints& points : patches) {
      for (const SidePoints& side : sides_of(points)) {
        const ClipPoint p[4] = {view.matrix(side[0]), view.matrix(side[1]), view.matrix(side[2]), view.matrix(side[3])};
        errors.add(chord_error(p, curve_steps(p, view.dice), view));
      }
    }
  }
  errors.check();
}

TEST(Dice, SoAreThoseInsideOfPatches) {
  const auto teapot = teapot_patches();
  ChordErrors errors;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const PatchView view = random_view(seed, any_distance(seed), seed % 2 == 0 ? 8 : 4);
    for (const auto& patches : {teapot, random_patches(seed, 2)}) {
      for (const PatchPoints& points : patches) errors.add(worst_inside(view.patch(points), view));
    }
  }
  errors.check();
}

TEST(Dice, CollapsedPatchesGiveWhatIsLeft) {
  const PatchView view = random_view(1, 1, 8);
  const auto facets_of_patch = [&](const ClipPatch& patch) {
    ClipPoint rows[2][kMaxSteps + 1];
    int facets = 0;
    dice(patch, view.dice, rows[0], rows[1], [&](const PatchFacet&) { ++facets; });
    return facets;
  };
  ClipPatch patch;
  for (auto& row : patch.at) {
    for (ClipPoint& p : row) p = {1000, 1000, 1 << 24};
  }
  EXPECT_EQ(facets_of_patch(patch), 0);  // a point
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) patch.at[i][j] = {1000 * i, 1000 * i, 1 << 24};
  }
  EXPECT_EQ(facets_of_patch(patch), 0);  // a line
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) patch.at[i][j] = {1000 * i, 1000 * j, 1 << 24};
  }
  EXPECT_EQ(facets_of_patch(patch), 1);  // a plane
}

}  // namespace
}  // namespace spanline::test
