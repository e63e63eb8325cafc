#include "oracle/sort_random.hpp"

#include <algorithm>

#include "oracle/random_polygon.hpp"

namespace spanline::oracle {
namespace {

constexpr int kFine = 2;  // units of the working grid in one of the vertices'
constexpr int kWide = kSortColumns * kSortUnits / kFine, kHigh = kSortLines * kSortUnits / kFine;
constexpr std::int64_t kOne = 65536, kDeepest = (std::int64_t{1} << 24) - 1;

AreaRing box(int left, int low, int right, int high) {
  return {{left, low}, {left, high}, {right, high}, {right, low}};
}

class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random_(seed) {}

  SortScene make() {
    for (int parts = random_.between(1, 3); parts > 0; --parts) {
      switch (random_.below(6)) {
        case 0:
          loose(random_.between(2, 14));
          break;
        case 1:
          layers(random_.between(2, 10));
          break;
        case 2:
          coplanar(random_.between(2, 8));
          break;
        case 3:
          cycle();
          break;
        case 4:
          interlocked();
          break;
        default:
          mesh();
          break;
      }
    }
    return std::move(scene_);
  }

 private:
  // Of vertices in their grid and a plane whose gradients are whole.
  void add(const AreaRegion& region, int along_x, int along_y, int at_centre) {
    SortPolygon polygon{static_cast<std::uint16_t>(scene_.size()), region, along_x * kOne, along_y * kOne, 0};
    polygon.at_origin =
        kOne * (at_centre - std::int64_t{along_x} * kWide * kFine / 2 - std::int64_t{along_y} * kHigh * kFine / 2);
    for (AreaRing& ring : polygon.region) {
      for (AreaPoint& p : ring) {
        p = {p.x * kFine, p.y * kFine};
        if (polygon.value(p) < 0 || polygon.value(p) > kDeepest * kOne) return;
      }
    }
    scene_.push_back(std::move(polygon));
  }

  AreaRegion shape() {
    const Place place{{random_.between(0, kWide), random_.between(0, kHigh)}, random_.between(20, 600)};
    AreaRegion region;
    for (const Contour& contour : random_polygon(random_, place, random_.percent(50) ? 64 : 1)) {
      AreaRing& ring = region.emplace_back();
      for (const Point p : contour) ring.push_back({p.x, p.y});
    }
    return region;
  }

  int slope() { return random_.between(-1800, 1800); }
  int depth() { return random_.between(5'000'000, 11'000'000); }

  void loose(int count) {
    const bool steep = random_.percent(60);
    for (; count > 0; --count) {
      const int reach = steep ? 1800 : 40;
      add(shape(), random_.between(-reach, reach), random_.between(-reach, reach), depth());
    }
  }

  void layers(int count) {
    for (; count > 0; --count) add(shape(), 0, 0, 100000 * random_.between(1, 160));
  }

  void coplanar(int count) {
    const int x = slope(), y = slope(), at = depth();
    for (; count > 0; --count) add(shape(), x, y, at);
  }

  // Three bars, each over the next.
  void cycle() {
    const int x = random_.between(100, kWide - 200), y = random_.between(100, kHigh - 200);
    const int steep = random_.between(200, 1500), at = depth();
    add({box(x, y, x + 300, y + 60)}, steep, 0, at);
    add({box(x + 240, y - 40, x + 300, y + 260)}, 0, steep,
        at - steep * (y - kHigh / 2) + steep * (x + 200 - kWide / 2));
    add({{{x, y - 20}, {x + 40, y - 30}, {x + 310, y + 240}, {x + 270, y + 250}}}, -steep, -steep,
        at + steep * (x - kWide / 2) + steep * (y + 100 - kHigh / 2) + steep * (x + 100 - kWide / 2));
  }

  // A comb whose teeth reach over and under a bar: the line of both planes runs between the teeth.
  void interlocked() {
    const int x = random_.between(50, kWide - 400), y = random_.between(50, kHigh - 300);
    const int steep = random_.between(1, 1500), at = depth();
    add({{{x, y},
          {x, y + 200},
          {x + 60, y + 200},
          {x + 60, y + 60},
          {x + 240, y + 60},
          {x + 240, y + 200},
          {x + 300, y + 200},
          {x + 300, y}}},
        steep, 0, at);
    add({box(x - 40, y + 100, x + 340, y + 150)}, -steep, 0, at + 2 * kFine * steep * (x + 150 - kWide / 2));
  }

  // A hilly net of triangles with shared edges; steps of 128 units make the gradients whole parts of 2^-16.
  void mesh() {
    constexpr int kStep = 128 / kFine;
    const int columns = random_.between(1, 5), rows = random_.between(1, 4);
    const int left = random_.between(-kStep, kWide - kStep), low = random_.between(-kStep, kHigh - kStep), at = depth();
    const int rough = random_.percent(50) ? 300000 : 4000;
    std::vector<int> height;
    for (int i = 0; i < (columns + 1) * (rows + 1); ++i) height.push_back(at + random_.between(-rough, rough));
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        const auto corner = [&](int dx, int dy) {
          return height[static_cast<std::size_t>((r + dy) * (columns + 1) + c + dx)];
        };
        const AreaPoint origin{left + c * kStep, low + r * kStep};
        facet(origin, kStep, corner(0, 0), corner(1, 0), corner(0, 1));
        facet({origin.x + kStep, origin.y + kStep}, -kStep, corner(1, 1), corner(0, 1), corner(1, 0));
      }
    }
  }

  void facet(AreaPoint at, int step, std::int64_t z, std::int64_t z_along_x, std::int64_t z_along_y) {
    const std::int64_t x = (z_along_x - z) * kOne / (step * kFine), y = (z_along_y - z) * kOne / (step * kFine);
    const AreaPoint origin{at.x * kFine, at.y * kFine};
    const AreaRing ring = {origin, {origin.x + step * kFine, origin.y}, {origin.x, origin.y + step * kFine}};
    scene_.push_back({static_cast<std::uint16_t>(scene_.size()), {ring}, x, y, z * kOne - x * origin.x - y * origin.y});
  }

  Random random_;
  SortScene scene_;
};

}  // namespace

SortScene random_sort_scene(std::uint64_t seed) { return Maker(seed).make(); }

int seen_at(const SortScene& scene, AreaPoint p) {
  int seen = -1;
  std::int64_t nearest = 0;
  for (const SortPolygon& polygon : scene) {
    bool on_border = false;
    if (!covers(polygon.region, {2 * p.x, 2 * p.y}, on_border)) continue;
    const std::int64_t value = polygon.value(p);
    if (seen >= 0 && (value < nearest || (value == nearest && polygon.source > seen))) continue;
    seen = polygon.source;
    nearest = value;
  }
  return seen;
}

}  // namespace spanline::oracle
