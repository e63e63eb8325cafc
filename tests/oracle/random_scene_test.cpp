#include "oracle/random_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/scene/scene_view.hpp"
#include "oracle/random_camera_scene.hpp"
#include "oracle/random_polygon.hpp"

namespace spanline::oracle {
namespace {

constexpr std::uint64_t kSeeds = 300;

TEST(RandomScene, IsTheSameForTheSameSeed) {
  const std::vector<Facet> a = random_screen_facets(7);
  const std::vector<Facet> b = random_screen_facets(7);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].contours.size(), b[i].contours.size());
    EXPECT_EQ(a[i].contours[0].front().x, b[i].contours[0].front().x);
    EXPECT_EQ(a[i].contours[0].front().z, b[i].contours[0].front().z);
  }
}

TEST(RandomScene, DepthsAreWholeUnitsAndFacesAreNumberedInOrder) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const std::vector<Facet> facets = random_screen_facets(seed);
    ASSERT_GE(facets.size(), 1u);
    ASSERT_LE(facets.size(), 60u);
    for (std::size_t i = 0; i < facets.size(); ++i) {
      ASSERT_EQ(facets[i].face, i);
      for (const auto& contour : facets[i].contours) {
        ASSERT_GE(contour.size(), 3u);
        for (const Vertex& vertex : contour) {
          ASSERT_EQ(vertex.z % 256, 0) << seed;
          ASSERT_TRUE(0 <= vertex.z && vertex.z <= 65535 * 256) << seed;
        }
      }
    }
  }
}

// What the comparison is for must really occur: otherwise a generator that drew nothing would pass every test.
TEST(RandomScene, HoldsEveryKindOfPicture) {
  int crossings = 0, holed = 0, concave = 0, empty_facets = 0, covered = 0, ties = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const std::vector<Facet> facets = random_screen_facets(seed);
    const Rendering rendering = render(64, 48, facets);
    std::set<std::uint32_t> seen;
    std::set<std::pair<std::uint32_t, std::uint32_t>> orders;
    for (int line = 0; line < 48; ++line) {
      for (int column = 0; column < 64; ++column) {
        const std::vector<Candidate>& candidates = rendering.candidates(column, line);
        for (const Candidate& each : candidates) seen.insert(each.face);
        for (std::size_t i = 1; i < candidates.size(); ++i) {
          orders.insert({candidates[0].face, candidates[i].face});
          ties += compare_depths(candidates[0].depth, candidates[i].depth) == 0;
        }
        covered += !candidates.empty();
      }
    }
    empty_facets += static_cast<int>(facets.size() - seen.size());
    crossings += static_cast<int>(std::count_if(orders.begin(), orders.end(), [&orders](const auto& pair) {
      return orders.count({pair.second, pair.first}) != 0;
    }));
    for (const Facet& facet : facets) {
      holed += facet.contours.size() > 1;
      concave += facet.contours[0].size() > 4;
    }
  }
  EXPECT_GT(crossings, 1000);
  EXPECT_GT(holed, 300);
  EXPECT_GT(concave, 1000);
  EXPECT_GT(empty_facets, 500);
  EXPECT_GT(ties, 1000);
  EXPECT_GT(covered, static_cast<int>(kSeeds) * 64 * 48 / 3);
}

TEST(RandomScene, LayersDoNotCross) {
  for (std::uint64_t seed = 0; seed < kSeeds; seed += 2) {
    const Rendering rendering = render(64, 48, random_screen_facets(seed));
    std::set<std::pair<std::uint32_t, std::uint32_t>> orders;
    for (int line = 0; line < 48; ++line) {
      for (int column = 0; column < 64; ++column) {
        const std::vector<Candidate>& candidates = rendering.candidates(column, line);
        for (std::size_t i = 1; i < candidates.size(); ++i) {
          if (!closer_than(candidates[0].depth, candidates[i].depth, 65536)) {
            orders.insert({candidates[0].face, candidates[i].face});
          }
        }
      }
    }
    for (const auto& [near, far] : orders) EXPECT_EQ(orders.count({far, near}), 0u) << seed;
  }
}

TEST(RandomPolygon, IsSimple) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const std::vector<Contour> contours = random_polygon(random, {{500, 400}, random.between(4, 3000)}, 1);
    if (contours.size() > 1 || contours[0].size() > 3) {
      EXPECT_TRUE(is_simple(contours)) << seed;
    }
  }
}

TEST(RandomPolygon, KnowsWhatIsNotSimple) {
  EXPECT_TRUE(is_simple({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}));                             // crosses itself
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 0}, {2, 0}, {0, 4}}}));                             // folds back
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}));                     // a corner on a side
  EXPECT_FALSE(is_simple({{{0, 0}, {4, 0}, {4, 0}, {0, 4}}}));                             // a side of no length
  EXPECT_FALSE(is_simple({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {12, 3}, {3, 6}}}));  // a hole sticks out
}

TEST(RandomCameraScene, RotationsAreOrthogonal) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Rotation rotation = random_rotation(random);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        std::int64_t product = 0;
        for (int k = 0; k < 3; ++k) product += rotation.entry[a][k] * rotation.entry[b][k];
        EXPECT_EQ(product, a == b ? rotation.divisor * rotation.divisor : 0);
      }
    }
  }
}

TEST(SceneStore, RecordsAreValidInEveryLayout) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SceneView view;
    SceneStore screen = screen_scene(random_screen_facets(seed), random_layout(seed));
    const SceneRecord screen_record = screen.record();
    Status status = SceneView::validate(screen_record, view);
    EXPECT_TRUE(status.ok()) << seed << ": " << status.where << " " << status.index << " " << status.field;
    CameraScene space = random_camera_scene(seed);
    const SceneRecord space_record = space.scene.record();
    status = SceneView::validate(space_record, view);
    EXPECT_TRUE(status.ok()) << seed << ": " << status.where << " " << status.index << " " << status.field;
  }
}

}  // namespace
}  // namespace spanline::oracle
