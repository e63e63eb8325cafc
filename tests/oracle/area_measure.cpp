#include "oracle/area_measure.hpp"

#include <algorithm>
#include <cmath>

namespace spanline::oracle {
namespace {

struct Border {
  AreaPoint low, high;  // by x
  unsigned region;

  long double y_at(long double x) const {
    return static_cast<long double>(low.y) + static_cast<long double>(high.y - low.y) *
                                                 (x - static_cast<long double>(low.x)) /
                                                 static_cast<long double>(high.x - low.x);
  }
};

std::int64_t turn(AreaPoint a, AreaPoint b, AreaPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

std::vector<Border> borders_of(const std::vector<AreaRegion>& regions) {
  std::vector<Border> borders;
  for (unsigned i = 0; i < regions.size(); ++i) {
    for (const AreaRing& ring : regions[i]) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const AreaPoint a = ring[k], b = ring[(k + 1) % ring.size()];
        if (a.x != b.x) borders.push_back({std::min(a, b), std::max(a, b), i});
      }
    }
  }
  std::sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) { return a.low.x < b.low.x; });
  return borders;
}

// Abscissae of all vertices and crossings of what is not vertical, ascending.
std::vector<long double> slab_sides(const std::vector<Border>& borders) {
  std::vector<long double> sides;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const Border& a = borders[i];
    sides.push_back(static_cast<long double>(a.low.x));
    sides.push_back(static_cast<long double>(a.high.x));
    for (std::size_t j = i + 1; j < borders.size() && borders[j].low.x < a.high.x; ++j) {
      const Border& b = borders[j];
      const std::int64_t before = turn(b.low, b.high, a.low), after = turn(b.low, b.high, a.high);
      const std::int64_t one = turn(a.low, a.high, b.low), other = turn(a.low, a.high, b.high);
      if ((before < 0) == (after < 0) || before == 0 || after == 0) continue;
      if ((one < 0) == (other < 0) || one == 0 || other == 0) continue;
      sides.push_back(static_cast<long double>(a.low.x) + static_cast<long double>(a.high.x - a.low.x) *
                                                              static_cast<long double>(before) /
                                                              static_cast<long double>(before - after));
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

}  // namespace

long double measure(const std::vector<AreaRegion>& regions, const std::function<bool(unsigned)>& wanted) {
  const std::vector<Border> borders = borders_of(regions);
  const std::vector<long double> sides = slab_sides(borders);
  std::vector<std::pair<long double, unsigned>> pile;
  std::vector<const Border*> active;
  std::size_t entering = 0;
  long double area = 0;
  for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
    while (entering < borders.size() && static_cast<long double>(borders[entering].low.x) <= sides[s]) {
      active.push_back(&borders[entering++]);
    }
    std::erase_if(active, [&](const Border* b) { return static_cast<long double>(b->high.x) <= sides[s]; });
    const long double middle = (sides[s] + sides[s + 1]) / 2;
    pile.clear();
    for (const Border* b : active) pile.emplace_back(b->y_at(middle), b->region);
    std::sort(pile.begin(), pile.end());
    unsigned mask = 0;
    for (std::size_t i = 0; i + 1 < pile.size(); ++i) {
      mask ^= 1u << pile[i].second;
      if (wanted(mask)) area += (pile[i + 1].first - pile[i].first) * (sides[s + 1] - sides[s]);
    }
  }
  return area;
}

bool covers(const AreaRegion& region, AreaPoint twice, bool& on_border) {
  bool inside = false;
  on_border = false;
  for (const AreaRing& ring : region) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      AreaPoint a{2 * ring[k].x, 2 * ring[k].y};
      AreaPoint b{2 * ring[(k + 1) % ring.size()].x, 2 * ring[(k + 1) % ring.size()].y};
      if (b < a) std::swap(a, b);
      const std::int64_t side = turn(a, b, twice);
      const bool in_box =
          a.x <= twice.x && twice.x <= b.x && std::min(a.y, b.y) <= twice.y && twice.y <= std::max(a.y, b.y);
      if (side == 0 && in_box) on_border = true;
      if (a.x <= twice.x && twice.x < b.x && side > 0) inside = !inside;
    }
  }
  return inside;
}

long double perimeter(const AreaRegion& region) {
  long double sum = 0;
  for (const AreaRing& ring : region) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const AreaPoint a = ring[k], b = ring[(k + 1) % ring.size()];
      sum += std::hypot(static_cast<long double>(b.x - a.x), static_cast<long double>(b.y - a.y));
    }
  }
  return sum;
}

}  // namespace spanline::oracle
