// A scene for growth: any number of polygons, nearly all of them partly visible, made where they are asked for. The
// screen is always the same, so polygons become smaller as there are more, and as many lie over a place on average.
#pragma once

#include "core/area/area_sort.hpp"
#include "core/fx/root.hpp"

namespace spanline::bench {

inline constexpr std::int32_t kGrowthSide = 32000;  // of the screen, units

class Scatter {
 public:
  explicit Scatter(std::uint32_t count)
      : count_(count), radius_(static_cast<std::int32_t>(kGrowthSide / square_root(count))) {}

  std::uint32_t count() const { return count_; }

  area::Box bounds(std::uint16_t i) const {
    const Corner c = centre(i);
    const auto at = [](std::int32_t x, std::int32_t y) {
      return area::GridPoint{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)};
    };
    return {at(c.x - radius_, c.y - radius_), at(c.x + radius_, c.y + radius_)};
  }

  // Kites at levels of their own, seen a little from the side.
  void put(std::uint16_t i, area::AreaSort& sort) const {
    const Corner c = centre(i);
    const std::uint32_t dice = mixed(i, 2);
    const std::int32_t wide = radius_ / 2 + static_cast<std::int32_t>(dice % static_cast<std::uint32_t>(radius_ / 2));
    const std::int32_t lean = static_cast<std::int32_t>(dice >> 24) - 128;
    sort.begin_polygon(i);
    sort.begin_contour();
    sort.vertex(c.x - wide, c.y + lean * radius_ / 256, depth(i));
    sort.vertex(c.x, c.y + radius_, depth(i) + 2);
    sort.vertex(c.x + wide, c.y - lean * radius_ / 256, depth(i));
    sort.vertex(c.x, c.y - radius_, depth(i) - 2);
    sort.end_contour();
    sort.end_polygon();
  }

 private:
  struct Corner {
    std::int32_t x, y;
  };

  static constexpr std::uint32_t mixed(std::uint32_t i, std::uint32_t salt) {
    std::uint32_t z = i * 0x9e3779b9u + salt * 0x85ebca6bu;
    z = (z ^ (z >> 16)) * 0x21f0aaadu;
    z = (z ^ (z >> 15)) * 0x735a2d97u;
    return z ^ (z >> 15);
  }
  Corner centre(std::uint16_t i) const {
    const auto place = [&](std::uint32_t salt) {
      return static_cast<std::int32_t>(mixed(i, salt) % static_cast<std::uint32_t>(kGrowthSide));
    };
    return {place(0), place(1)};
  }
  static std::int32_t depth(std::uint16_t i) {
    return 1000 + 16 * static_cast<std::int32_t>(mixed(i, 3) & 0xffff) + (i & 7);
  }

  std::uint32_t count_;
  std::int32_t radius_;
};

inline constexpr area::Box kGrowthScreen{{0, 0}, {kGrowthSide, kGrowthSide}};

struct CountPieces {
  std::uint32_t pieces = 0, vertices = 0;
  void begin_piece(std::uint16_t, const area::Plane&) { ++pieces; }
  void film(std::uint16_t) {}
  void begin_contour() {}
  void vertex(area::GridPoint) { ++vertices; }
  void end_contour() {}
  void end_piece() {}
};

}  // namespace spanline::bench
