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

TEST(ClipRow, IsTheMatrixRowByAnyKindOfProduct) {
  oracle::Random random(3);
  const auto any = [&random](int bits) { return static_cast<std::int32_t>(random.next() >> 32) >> (32 - bits); };
  int fitting = 0;
  for (int round = 0; round < oracle::rounds(20000); ++round) {
    ClipMatrix matrix{};
    for (int i = 0; i < 3; ++i) {
      for (std::int32_t& c : matrix.linear[i]) c = any(random.between(1, 31));
      matrix.offset[i] = any(random.between(1, 32));
    }
    if (!matrix.fits()) continue;
    ++fitting;
    for (int i = 0; i < 3; ++i) {
      const LongRow whole(matrix, i);
      const SplitRow split(matrix, i);
      const PackedRow packed(matrix, i);
      for (int p = 0; p < 8; ++p) {
        const auto end = [&](int value) {
          return static_cast<std::int16_t>(p < 4 ? value : value < 0 ? -32768 : 32767);
        };
        const Position at{end(any(16)), end(any(16)), end(any(16))};
        const std::int32_t expected = matrix.row(i, at);
        ASSERT_EQ(whole.at(at), expected);
        ASSERT_EQ(split.at(at), expected);
        ASSERT_EQ(packed.at(at), expected);
        const ClipPoint all = ClipRows(matrix)(at);
        ASSERT_EQ(i == 0 ? all.x : i == 1 ? all.y : all.w, expected);
      }
    }
  }
  EXPECT_GT(fitting, oracle::rounds(5000));
}

// Where all corners of a box are well inside the view all positions in it are inside, and differ by less than 2^15 on
// the screen.
TEST(Projection, ABoxWellInsideHoldsWhatIsInside) {
  oracle::Random random(11);
  const auto any = [&random](int bits) { return static_cast<std::int32_t>(random.next() >> 32) >> (32 - bits); };
  int boxes = 0;
  for (int round = 0; round < oracle::rounds(60000); ++round) {
    ClipMatrix matrix{};
    const int size = random.between(4, 24), distance = size + random.between(0, 3);
    for (auto& row : matrix.linear) {
      for (std::int32_t& c : row) c = any(size);
    }
    matrix.offset[0] = any(distance), matrix.offset[1] = any(distance);
    matrix.offset[2] = (1 << (distance - 1)) + random.below(1 << 10);
    if (!matrix.fits()) continue;
    const auto end = [&] { return static_cast<std::int16_t>(any(16)); };
    const Position a{end(), end(), end()}, b{end(), end(), end()};
    const PositionBox box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
    CameraRecord camera{};
    camera.near_plane.raw = random.between(1, 2000);
    camera.far_plane.raw = INT32_MAX;
    const Projection projection(camera, {kMaxExtent, kMaxExtent, PixelFormat::rgb565});
    const ClipRows to_clip(matrix);
    if (!projection.well_inside(box, to_clip)) continue;
    ++boxes;
    std::vector<ScreenXY> points;
    for (int i = 0; i < 40; ++i) {
      const auto within = [&](std::int16_t low, std::int16_t high) {
        return static_cast<std::int16_t>(random.percent(60) ? (random.percent(50) ? low : high)
                                                            : random.between(low, high));
      };
      const Position p{within(box.low.x, box.high.x), within(box.low.y, box.high.y), within(box.low.z, box.high.z)};
      ASSERT_TRUE(box.holds(p));
      const ClipPoint clip = to_clip(p);
      ASSERT_EQ(projection.outcode(clip), 0) << "round " << round;
      points.push_back(projection(clip).at);
    }
    const auto by_x = [](ScreenXY p, ScreenXY q) { return p.x < q.x; };
    const auto by_y = [](ScreenXY p, ScreenXY q) { return p.y < q.y; };
    const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_x);
    const auto [top, bottom] = std::minmax_element(points.begin(), points.end(), by_y);
    ASSERT_LT(right->x - left->x, 1 << 15);
    ASSERT_LT(bottom->y - top->y, 1 << 15);
    for (std::size_t i = 2; i < points.size(); ++i) {
      const PackedXY p(points[i - 2]), q(points[i - 1]), r(points[i]);
      ASSERT_EQ(cross_halves(subtract_halves(q.word, p.word), subtract_halves(r.word, p.word)), doubled_area(p, q, r));
      ASSERT_EQ(doubled_area_near(p, q, r), doubled_area(p, q, r));
    }
  }
  EXPECT_GT(boxes, oracle::rounds(2000));
}

}  // namespace
}  // namespace spanline::test
