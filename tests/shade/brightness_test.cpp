// A smooth triangle's brightness against the plane in doubles, at every pixel inside it.
#include "core/shade/brightness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/shade/painter.hpp"
#include "oracle/random.hpp"

namespace spanline {
namespace {

using oracle::Random;

double cross(ScreenXY a, ScreenXY b, double x, double y) { return (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y); }

TEST(BrightnessPlane, IsLinearAndNeverOutOfTheTable) {
  int pixels = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Random random(seed);
    const int reach = random.percent(20) ? 12000 : random.percent(50) ? 900 : 60;
    ScreenXY at[3];
    Brightness level[3];
    for (int i = 0; i < 3; ++i) {
      at[i] = {static_cast<std::int16_t>(random.between(-reach, reach)),
               static_cast<std::int16_t>(random.between(-reach, reach))};
      level[i] = static_cast<Brightness>(random.percent(30) ? random.below(2) * 252 : random.below(253));
    }
    if (random.percent(30)) {  // a sliver
      at[2].x = static_cast<std::int16_t>((at[0].x + at[1].x) / 2 + random.between(-1, 1));
      at[2].y = static_cast<std::int16_t>((at[0].y + at[1].y) / 2 + random.between(-1, 1));
    }
    const double area = cross(at[0], at[1], at[2].x, at[2].y);
    if (area == 0) continue;
    const BrightnessPlane plane = brightness_plane(at, level);
    for (int i = 0; i < 40; ++i) {
      // A pixel near a random point of the triangle.
      const double p = random.below(1001) / 1000.0, q = (1 - p) * random.below(1001) / 1000.0;
      const int column =
          static_cast<int>(std::floor((at[0].x + p * (at[1].x - at[0].x) + q * (at[2].x - at[0].x)) / 16));
      const int line = static_cast<int>(std::floor((at[0].y + p * (at[1].y - at[0].y) + q * (at[2].y - at[0].y)) / 16));
      const double x = 16 * column + 8, y = 16 * line + 8;
      const double b = cross(at[0], {at[2].x, at[2].y}, x, y) / -area, c = cross(at[0], at[1], x, y) / area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      ++pixels;
      const double exact = level[0] + b * (level[1] - level[0]) + c * (level[2] - level[0]);
      const std::uint32_t value = plane.at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(line));
      ASSERT_NEAR(value / double{1 << 24} - 2, exact, 0.25) << "seed " << seed;
    }
  }
  EXPECT_GT(pixels, 10000);
}

TEST(SmoothSpan, RoundsToTheNearestColour) {
  FaceLook looks[1];
  ColorTable tables[1];
  SmoothCache cache({{looks, 0}, {tables, 0}}, PixelFormat::rgb565);
  EXPECT_FALSE(cache.on()) << "nothing but the sink: off";
  alignas(4) std::uint8_t line[16];
  Painter painter({8, 1, PixelFormat::rgb565});
  painter.begin_lines({});
  painter.begin_line(0, line);
  std::uint16_t colors[ColorTable::kEntries];
  for (std::uint32_t i = 0; i < ColorTable::kEntries; ++i) colors[i] = static_cast<std::uint16_t>(1000 + i);
  painter.fill(0, 8, 7);
  painter.smooth(1, 7, {std::uint32_t{1} << 25, std::uint32_t{5} << 24, 0}, colors);
  const auto* pixel = reinterpret_cast<const std::uint16_t*>(line);
  const std::uint16_t expected[] = {7, 1001, 1003, 1004, 1005, 1006, 1008, 7};  // 1.25 a column
  for (int i = 0; i < 8; ++i) EXPECT_EQ(pixel[i], expected[i]) << i;
}

}  // namespace
}  // namespace spanline
