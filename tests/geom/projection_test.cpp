// Every projected vertex is the nearest 1/16 px to the exact place, or its neighbour.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geom/facet.hpp"
#include "geom/exact_projection.hpp"
#include "oracle/random_camera_scene.hpp"

namespace spanline::test {
namespace {

constexpr Screen kScreen{64, 48, PixelFormat::rgb565};

// The nearest is at most half a unit away, its neighbour at most one and a half.
constexpr long double kNeighbour = 1.5L;
// Clip space has 16 bits of fraction: nearer to the eye than a world unit a vertex may be some sixteenths off
// (projection.hpp).
constexpr long double kUnit = 1;
constexpr long double kTooNear = 5;

struct Corners {
  std::vector<FacetVertex> all;
  void begin_contour() {}
  void vertex(const FacetVertex& vertex) { all.push_back(vertex); }
  void end_contour() {}
};

TEST(Projection, IsTheNearestSixteenthOrItsNeighbour) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < oracle::rounds(3000u); ++seed) {
    oracle::CameraScene space = oracle::random_camera_scene(seed);
    const SceneRecord record = space.scene.record();
    SceneView scene;
    ASSERT_TRUE(SceneView::validate(record, scene).ok());
    ScreenPoint sink[1];
    FacetReader reader(scene, space.camera, kScreen, PoolRef<ScreenPoint>(sink, 0));
    for (std::uint16_t face = 0; face < scene.face_count(); ++face) {
      reader.select(face);
      if (reader.clipped()) continue;
      Corners corners;
      reader.read([](std::uint16_t) { return Rgb8{}; }, corners);
      ASSERT_EQ(corners.all.size(), reader.face().corners.size());
      for (std::uint32_t i = 0; i < corners.all.size(); ++i) {
        const Position& position = reader.mesh().positions[reader.face().corners[i]];
        const auto point = seen_from(space.camera, reader.instance(), reader.mesh(), position);
        const ExactPoint exact = project(point, space.camera, kScreen.width, kScreen.height);
        const FacetVertex& corner = corners.all[i];
        const long double error = std::max(std::fabs(corner.at.x - exact.x), std::fabs(corner.at.y - exact.y));
        const bool far_enough = point.ahead >= kUnit;
        ASSERT_LT(error, far_enough ? kNeighbour : kTooNear) << "seed " << seed << ", face " << face;
        ASSERT_LT(std::fabs(corner.depth / 256.0L - exact.depth), far_enough ? 1 : 8)
            << "seed " << seed << ", face " << face;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, oracle::rounds(10000));
}

}  // namespace
}  // namespace spanline::test
