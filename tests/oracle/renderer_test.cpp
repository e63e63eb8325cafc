#include "oracle/renderer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "oracle/random.hpp"
#include "oracle/random_polygon.hpp"

namespace spanline::oracle {
namespace {

using Text = std::vector<std::string>;
using Ring = std::vector<Vertex>;

constexpr std::int64_t kUnit = 256;

// Corners in whole pixels, all at one depth.
Ring ring(std::initializer_list<Point> corners, std::int64_t z = 0) {
  Ring result;
  for (const Point& p : corners) result.push_back({p.x * 16, p.y * 16, z});
  return result;
}

Text draw(int width, int height, const std::vector<Facet>& facets) {
  return to_text(render(width, height, facets).picture());
}

TEST(Oracle, NothingIsBackground) { EXPECT_EQ(draw(3, 2, {}), (Text{"...", "..."})); }

TEST(Oracle, SquareCoversItsCentres) {
  EXPECT_EQ(draw(6, 4, {{0, {ring({{2, 1}, {4, 1}, {4, 3}, {2, 3}})}}}),
            (Text{"......", "..##..", "..##..", "......"}));
}

TEST(Oracle, TopAndLeftEdgesThroughCentresAreIn) {
  const Ring square{{8, 8, 0}, {40, 8, 0}, {40, 40, 0}, {8, 40, 0}};
  EXPECT_EQ(draw(4, 4, {{0, {square}}}), (Text{"##..", "##..", "....", "...."}));
}

TEST(Oracle, JustRightOfACentreIsOut) {
  const Ring square{{9, 9, 0}, {41, 9, 0}, {41, 41, 0}, {9, 41, 0}};
  EXPECT_EQ(draw(4, 4, {{0, {square}}}), (Text{"....", ".##.", ".##.", "...."}));
}

TEST(Oracle, DiagonalThroughCentresBelongsToTheRight) {
  const Facet left{0, {ring({{0, 0}, {4, 4}, {0, 4}})}};
  const Facet right{1, {ring({{0, 0}, {4, 0}, {4, 4}})}};
  EXPECT_EQ(draw(4, 4, {left, right}), (Text{"1111", "#111", "##11", "###1"}));
}

TEST(Oracle, HoleIsEvenOdd) {
  const Facet frame{0, {ring({{0, 0}, {5, 0}, {5, 4}, {0, 4}}), ring({{1, 1}, {4, 1}, {4, 3}, {1, 3}})}};
  EXPECT_EQ(draw(5, 4, {frame}), (Text{"#####", "#...#", "#...#", "#####"}));
}

TEST(Oracle, ConcaveW) {
  const Facet w{0, {ring({{0, 0}, {3, 3}, {6, 0}, {6, 4}, {0, 4}})}};
  EXPECT_EQ(draw(6, 4, {w}), (Text{".....#", "#...##", "##.###", "######"}));
}

TEST(Oracle, CrossedQuadFillsBothLoops) {
  const Facet bow{0, {ring({{0, 0}, {4, 4}, {4, 0}, {0, 4}})}};
  EXPECT_EQ(draw(4, 4, {bow}), (Text{"...#", "#.##", "#.##", "...#"}));
}

TEST(Oracle, FarVerticesDoNotOverflow) {
  const Ring huge{
      {-32768, -32768, 0}, {32767, -32768, 65535 * kUnit}, {32767, 32767, 0}, {-32768, 32767, 65535 * kUnit}};
  EXPECT_EQ(draw(2, 2, {{0, {huge}}}), (Text{"##", "##"}));
}

TEST(Oracle, NearerIsSeenWhateverTheOrder) {
  const Facet far{0, {ring({{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 10)}};
  const Facet near{1, {ring({{1, 0}, {4, 0}, {4, 2}, {1, 2}}, 11)}};
  EXPECT_EQ(draw(4, 2, {far, near}), (Text{"#111", "#111"}));
  EXPECT_EQ(draw(4, 2, {near, far}), (Text{"#111", "#111"}));
}

TEST(Oracle, EqualDepthsGoToTheLowerNumber) {
  const Ring square = ring({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 7);
  EXPECT_EQ(draw(2, 1, {{1, {square}}, {0, {square}}}), (Text{"##"}));
}

TEST(Oracle, PlanesCrossWhereTheirDepthsAreEqual) {
  // Depths at centre c: 16 c + 8 up, 128 - (16 c + 8) down: equal between the columns 3 and 4.
  const Facet up{0, {{{0, 0, 0}, {128, 0, 128}, {128, 16, 128}, {0, 16, 0}}}};
  const Facet down{1, {{{0, 0, 128}, {128, 0, 0}, {128, 16, 0}, {0, 16, 128}}}};
  EXPECT_EQ(draw(8, 1, {up, down}), (Text{"1111####"}));
}

TEST(Oracle, DepthIsThePlaneOfATriangle) {
  const Facet facet{0, {{{0, 0, 1000}, {160, 0, 1000 + 160 * 3}, {0, 160, 1000 - 160 * 5}}}};
  const Rendering rendering = render(10, 10, {facet});
  int covered = 0;
  for (int line = 0; line < 10; ++line) {
    for (int column = 0; column < 10; ++column) {
      for (const Candidate& each : rendering.candidates(column, line)) {
        const Depth plane{1000 + 3 * (16 * column + 8) - 5 * (16 * line + 8), 1};
        EXPECT_EQ(compare_depths(each.depth, plane), 0) << column << ", " << line;
        ++covered;
      }
    }
  }
  EXPECT_EQ(covered, 45);
}

TEST(Oracle, DepthOfATwistedQuadIsBetweenItsEdgesOnTheLine) {
  const Facet facet{0, {{{0, 0, 0}, {32, 0, 320}, {32, 32, 0}, {0, 32, 320}}}};
  const Rendering rendering = render(2, 2, {facet});
  // At y = 8 the left edge stands at 80, the right one at 240; x = 8 is a quarter of the way.
  EXPECT_EQ(compare_depths(rendering.candidates(0, 0).front().depth, {120, 1}), 0);
  EXPECT_EQ(compare_depths(rendering.candidates(1, 1).front().depth, {120, 1}), 0);
}

TEST(Oracle, SliverBetweenCentresCoversNothing) {
  EXPECT_EQ(draw(3, 1, {{0, {{{9, 0, 0}, {23, 0, 0}, {23, 16, 0}, {9, 16, 0}}}}}), (Text{"..."}));
}

TEST(Oracle, TrianglesRoundACornerTileTheirPolygon) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const int step = random.percent(50) ? 1 : 8;
    const Vertex middle{random.between(160, 360) / step * step, random.between(160, 360) / step * step, 0};
    Ring outline;
    for (int i = 0; i < 9; ++i) {
      const Point p = circle_point(1024 * i / 9);
      outline.push_back({middle.x + p.x / 120 / step * step, middle.y + p.y / 120 / step * step, 0});
    }
    std::vector<Facet> fan;
    for (std::size_t i = 0; i < 9; ++i) fan.push_back({0, {{middle, outline[i], outline[(i + 1) % 9]}}});
    const Rendering whole = render(32, 32, {{0, {outline}}});
    const Rendering parts = render(32, 32, fan);
    for (int line = 0; line < 32; ++line) {
      for (int column = 0; column < 32; ++column) {
        EXPECT_EQ(parts.candidates(column, line).size(), whole.candidates(column, line).size());
      }
    }
  }
}

TEST(Oracle, RefusesWhatItsIntegersDoNotHold) {
  EXPECT_THROW(render(2, 2, {{0, {{{0, 0, 0}, {32768, 0, 0}, {0, 9, 0}}}}}), std::invalid_argument);
  EXPECT_THROW(render(2, 2, {{0, {{{0, 0, 0}, {9, 0, kMaxDepth + 1}, {0, 9, 0}}}}}), std::invalid_argument);
  EXPECT_THROW(render(0, 2, {}), std::invalid_argument);
  EXPECT_THROW(render(2, 2047, {}), std::invalid_argument);
}

}  // namespace
}  // namespace spanline::oracle
