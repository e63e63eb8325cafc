#include "oracle/area_random.hpp"

#include <algorithm>

namespace spanline::oracle {
namespace {

// Shapes in lattice units, 0 … size in both coordinates.
class Shapes {
 public:
  Shapes(Random& random, int size) : random_(random), size_(size) {}

  AreaRegion any() {
    switch (random_.below(8)) {
      case 0:
        return {star()};
      case 1:
        return {comb()};
      case 2:
        return {spiral()};
      case 3:
        return nested();
      case 4:
        return cells();
      case 5:
        return {wild(random_.between(3, 12))};
      case 6:
        return {wild(3), wild(3), wild(4)};
      default: {
        AreaRegion both = any_simple();
        for (AreaRing& ring : any_simple()) both.push_back(std::move(ring));
        return both;
      }
    }
  }

 private:
  AreaRegion any_simple() {
    switch (random_.below(4)) {
      case 0:
        return {star()};
      case 1:
        return {comb()};
      case 2:
        return nested();
      default:
        return cells();
    }
  }

  AreaPoint anywhere() { return {random_.between(0, size_), random_.between(0, size_)}; }

  AreaRing wild(int count) {
    AreaRing ring;
    for (int i = 0; i < count; ++i) ring.push_back(anywhere());
    return ring;
  }

  // Points in the order of their angle around a centre.
  AreaRing star() {
    const AreaPoint centre = anywhere();
    AreaRing ring;
    for (int i = random_.between(3, 16); i > 0; --i) {
      const AreaPoint p = anywhere();
      if (p != centre) ring.push_back(p);
    }
    const auto lower = [&](AreaPoint p) { return p.y < centre.y || (p.y == centre.y && p.x < centre.x); };
    std::sort(ring.begin(), ring.end(), [&](AreaPoint a, AreaPoint b) {
      if (lower(a) != lower(b)) return lower(b);
      const std::int64_t turn = (a.x - centre.x) * (b.y - centre.y) - (a.y - centre.y) * (b.x - centre.x);
      return turn != 0 ? turn > 0 : a < b;
    });
    return ring;
  }

  AreaRing comb() {
    const int teeth = random_.between(1, std::max(1, size_ / 2)), low = random_.between(0, size_ - 1);
    const bool pointed = random_.percent(40), upright = random_.percent(50);
    AreaRing ring;
    for (int i = 0; i < teeth; ++i) {
      const int top = random_.between(low + 1, size_);
      ring.push_back({2 * i, low});
      ring.push_back({2 * i, top});
      if (!pointed) ring.push_back({2 * i + 1, top});
      ring.push_back({2 * i + 1, low});
    }
    ring.push_back({2 * teeth - 1, 0});
    ring.push_back({0, 0});
    if (upright) return ring;
    for (AreaPoint& p : ring) std::swap(p.x, p.y);
    return ring;
  }

  // A rectangular band that winds inwards, one unit wide with gaps of one.
  AreaRing spiral() {
    AreaRing out, back;
    int left = 0, low = 0, right = size_, high = size_;
    out.push_back({left, low});
    while (right - left > 3 && high - low > 3) {
      out.push_back({right, low});
      out.push_back({right, high});
      out.push_back({left, high});
      out.push_back({left, low + 2});
      back.push_back({left + 1, low + 2 + 1});
      back.push_back({left + 1, high - 1});
      back.push_back({right - 1, high - 1});
      back.push_back({right - 1, low + 1});
      left += 2;
      low += 2;
      right -= 2;
      high -= 2;
      if (random_.percent(30)) break;
    }
    std::reverse(back.begin(), back.end());
    out.insert(out.end(), back.begin(), back.end());
    out.push_back({0, 1});
    return out;
  }

  AreaRegion nested() {
    AreaRegion region;
    const int middle = size_ / 2;
    for (int radius = middle; radius > 0; radius -= random_.between(1, 3)) {
      if (random_.percent(50)) {
        region.push_back({{middle - radius, middle - radius},
                          {middle + radius, middle - radius},
                          {middle + radius, middle + radius},
                          {middle - radius, middle + radius}});
      } else {
        region.push_back({{middle - radius, middle},
                          {middle, middle - radius},
                          {middle + radius, middle},
                          {middle, middle + radius}});
      }
    }
    return region;
  }

  AreaRegion cells() {
    AreaRegion region;
    const int pitch = random_.between(1, std::max(1, size_ / 3)), chance = random_.between(20, 90);
    for (int x = 0; x + pitch <= size_ && x < 5 * pitch; x += pitch) {
      for (int y = 0; y + pitch <= size_ && y < 5 * pitch; y += pitch) {
        if (random_.percent(chance)) region.push_back({{x, y}, {x + pitch, y}, {x + pitch, y + pitch}, {x, y + pitch}});
      }
    }
    return region;
  }

  Random& random_;
  int size_;
};

}  // namespace

AreaPair random_area_pair(std::uint64_t seed) {
  Random random(seed);
  const int size = random.between(2, 14);
  Shapes shapes(random, size);
  AreaPair pair{shapes.any(), shapes.any()};
  if (random.percent(15)) {
    pair.clip = pair.subject;
    const int how = random.below(4);
    const int shift = how == 0 ? random.between(0, 2) : 0;
    for (AreaRing& ring : pair.clip) {
      if (how == 1) std::reverse(ring.begin(), ring.end());
      for (AreaPoint& p : ring) {
        p.x += shift;
        if (how == 2) p.x = size - p.x;
        if (how == 3) std::swap(p.x, p.y);
      }
    }
  }
  // Lattice units: from 1, where nearly every crossing is rounded onto its neighbours, to what fills the grid.
  // Multiples of 840 leave many crossings on the grid.
  constexpr int kPitches[] = {1, 1, 2, 3, 7, 16, 60, 840, 840, 2340};
  const int pitch = kPitches[random.below(10)];
  for (AreaRegion* region : {&pair.subject, &pair.clip}) {
    for (AreaRing& ring : *region) {
      for (AreaPoint& p : ring) p = {(p.x - size / 2) * pitch, (p.y - size / 2) * pitch};
    }
  }
  return pair;
}

}  // namespace spanline::oracle
