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

// A convex cell: four points around a circle, pulled out of shape, or three of which one stands twice.
void make_cell(Random& random, ScreenXY (&at)[4]) {
  const int reach = random.percent(20) ? 12000 : random.percent(50) ? 900 : 60;
  const double wide = reach * random.between(1, 100) / 100.0, turn = random.below(1000) / 159.0;
  double angle = random.below(1000) / 159.0;
  for (ScreenXY& p : at) {
    const double x = wide * std::cos(angle), y = reach * std::sin(angle);
    p = {static_cast<std::int16_t>(16000 + std::lround(x * std::cos(turn) - y * std::sin(turn))),
         static_cast<std::int16_t>(16000 + std::lround(x * std::sin(turn) + y * std::cos(turn)))};
    angle += random.below(1000) / 500.0;
  }
  if (random.percent(10)) at[1] = at[0];
}

bool convex(const ScreenXY (&at)[4]) {
  bool left = false, right = false;
  for (int i = 0; i < 4; ++i) {
    const ScreenXY& c = at[(i + 2) % 4];
    const double turn = cross(at[i], at[(i + 1) % 4], c.x, c.y);
    left = left || turn < 0;
    right = right || turn > 0;
  }
  return left != right;
}

// The plane that grows along the diagonals as the corners do, and has their mean in the mean of their places.
TEST(CellBrightness, IsThePlaneOfTheDiagonalsAndNeverOutOfTheTable) {
  int cells = 0, moved = 0, exact_ones = 0;
  for (std::uint64_t seed = 0; seed < 40000; ++seed) {
    Random random(seed);
    ScreenXY at[4];
    make_cell(random, at);
    Brightness level[4];
    const int spread = random.percent(60) ? 20 : 252, least = random.below(253 - spread);
    for (Brightness& l : level) l = static_cast<Brightness>(least + random.below(spread + 1));
    const double ux = at[2].x - at[0].x, uy = at[2].y - at[0].y, vx = at[3].x - at[1].x, vy = at[3].y - at[1].y;
    const double area = ux * vy - vx * uy;
    if (!convex(at) || std::abs(area) < 1) continue;
    ++cells;
    const double rise_u = level[2] - level[0], rise_v = level[3] - level[1];
    const double right = (rise_u * vy - rise_v * uy) / area * 16, down = (rise_v * ux - rise_u * vx) / area * 16;
    const auto sum = [&](auto of) { return of(0) + of(1) + of(2) + of(3); };
    const double mean = sum([&](int i) { return level[i] - (right * at[i].x + down * at[i].y) / 16; }) / 4;
    const auto corner = [&](int i) { return mean + (right * at[i].x + down * at[i].y) / 16; };
    const BrightnessPlane plane = cell_brightness(at, level);
    const bool steep = std::abs(right) > 1000 || std::abs(down) > 1000;
    double low = 1000, high = -1000;
    for (int i = 0; i < 4; ++i) {
      low = std::min(low, corner(i));
      high = std::max(high, corner(i));
    }
    const bool within = low >= 0 && high <= 252;
    for (int i = 0; i < 10; ++i) {
      // A pixel near a random point of the cell.
      double part[4], all = 0;
      for (double& p : part) all += p = random.below(1000) * (random.percent(30) ? 0 : 1) + 0.001;
      const auto mix = [&](auto of) { return sum([&](int c) { return part[c] / all * of(at[c]); }); };
      const int column = static_cast<int>(std::floor(mix([](ScreenXY p) { return static_cast<double>(p.x); }) / 16));
      const int line = static_cast<int>(std::floor(mix([](ScreenXY p) { return static_cast<double>(p.y); }) / 16));
      const double x = 16 * column + 8, y = 16 * line + 8;
      bool inside = true;
      for (int c = 0; c < 4; ++c) inside = inside && cross(at[c], at[(c + 1) % 4], x, y) * area >= 0;
      if (!inside) continue;
      const double value =
          plane.at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(line)) / double{1 << 24} - 2;
      const double expected = mean + (right * x + down * y) / 16;
      if (steep || !within) {
        ++moved;
        ASSERT_LE(std::abs(value - 126), 127.5) << "seed " << seed;
        if (!steep && high - low < 252) {
          ASSERT_NEAR(value, expected + (low < 0 ? -low : 252 - high), 1.5) << "seed " << seed;
        }
        continue;
      }
      ++exact_ones;
      ASSERT_NEAR(value, expected, 0.25) << "seed " << seed;
    }
  }
  EXPECT_GT(cells, 20000);
  EXPECT_GT(moved, 1000);
  EXPECT_GT(exact_ones, 40000);
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
