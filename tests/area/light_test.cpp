// The view of a light against a shadow ray for each of many places: the twin asks every polygon of the scene.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "area/sorted.hpp"
#include "core/area/light_view.hpp"

namespace spanline::area::test {
namespace {

using oracle::SortPolygon;
using oracle::SortScene;

bool is_pane(std::uint16_t source) { return source % 3 == 0; }

// Where a polygon's own grid has what the light sees at p: turned and sheared, another way for each.
AreaPoint own_place(std::uint16_t source, AreaPoint p) {
  const std::int64_t twist = source % 5 - 2;
  return {3 * p.x + twist * p.y, 2 * p.y - twist * p.x + source};
}

GridPoint grid(AreaPoint p) { return {static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y)}; }

class LitScene {
 public:
  explicit LitScene(const SortScene& polygons) : polygons_(polygons) {
    for (const SortPolygon& polygon : polygons_) {
      Box& box = bounds_.emplace_back(Box::none());
      Carrier& carrier = carriers_.emplace_back();
      for (const AreaRing& ring : polygon.region) {
        for (const AreaPoint& p : ring) {
          box.widen(grid(p));
          carrier.corner(grid(p), grid(own_place(polygon.source, p)));
        }
      }
    }
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(polygons_.size()); }
  const Box& bounds(std::uint16_t i) const { return bounds_[i]; }
  const Carrier& carrier(std::uint16_t i) const { return carriers_[i]; }
  void put(std::uint16_t i, AreaSort& sort) const {
    test::put(sort, polygons_[i], is_pane(polygons_[i].source) ? Opacity::translucent : Opacity::opaque);
  }

 private:
  const SortScene& polygons_;
  std::vector<Box> bounds_;
  std::vector<Carrier> carriers_;
};

// A part of a polygon, on its own grid.
struct Part {
  std::uint16_t source;
  std::vector<std::uint16_t> films;
  AreaRegion region;
};

struct Collect {
  std::vector<Part> parts;
  void begin_part(std::uint16_t source) { parts.push_back({source, {}, {}}); }
  void film(std::uint16_t source) { parts.back().films.push_back(source); }
  void begin_contour() { parts.back().region.emplace_back(); }
  void vertex(GridPoint p) { parts.back().region.back().push_back({p.x, p.y}); }
  void end_contour() {}
  void end_part() {}
};

// The scene with its polygons numbered as they stand, which a light's view asks for.
SortScene numbered(std::uint64_t seed) {
  SortScene scene = oracle::random_sort_scene(seed);
  for (std::size_t i = 0; i < scene.size(); ++i) scene[i].source = static_cast<std::uint16_t>(i);
  return scene;
}

std::vector<Part> lit_parts(const SortScene& scene) {
  static const auto storage = std::make_unique<SortStorage<400, 30000, 6000, 20000>>();
  static Pool<std::uint16_t, 400> names;
  AreaSort sort(storage->refs(), Panes::shown);
  const LitScene lit(scene);
  Collect collect;
  LightView<LitScene, Collect> view(lit, collect);
  const Status status = view.solve(sort, names.ref(), 0, Box::all());
  EXPECT_TRUE(status.ok()) << status.where;
  return std::move(collect.parts);
}

// What stands between the light and a polygon at `p`, by name: panes, or an opaque polygon, which keeps the light.
struct Ray {
  bool lit = true;
  std::vector<std::uint16_t> films;
};
Ray shadow_ray(const SortScene& scene, const SortPolygon& at, AreaPoint p) {
  Ray ray;
  for (const SortPolygon& other : scene) {
    bool on = false;
    if (other.source == at.source || !oracle::covers(other.region, {2 * p.x, 2 * p.y}, on)) continue;
    const std::int64_t lead = other.value(p) - at.value(p);
    if (lead < 0 || (lead == 0 && other.source > at.source)) continue;
    if (!is_pane(other.source)) ray.lit = false;
    ray.films.push_back(other.source);
  }
  return ray;
}

// Whether a border of the scene, or a line where two polygons pierce one another, passes that near: there either may be
// lit, and all the more on a grid that is coarser than the polygon's own.
bool near_an_edge(const SortScene& scene, const std::vector<Part>& parts, std::uint16_t source, AreaPoint p) {
  constexpr double kReach = 2.5;
  const auto near_ring = [](const AreaRing& ring, AreaPoint at, double reach) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (distance(at, ring[i], ring[(i + 1) % ring.size()]) <= reach) return true;
    }
    return false;
  };
  for (const SortPolygon& polygon : scene) {
    for (const AreaRing& ring : polygon.region) {
      if (near_ring(ring, p, kReach)) return true;
    }
  }
  for (const Part& part : parts) {
    if (part.source != source) continue;
    for (const AreaRing& ring : part.region) {
      if (near_ring(ring, own_place(source, p), 4 * kReach)) return true;
    }
  }
  return false;
}

TEST(LightView, WhatItLightsIsWhatShadowRaysReach) {
  const std::uint64_t scenes = std::getenv("SPANLINE_FULL") != nullptr ? 2000 : 100;
  std::uint64_t looked = 0, unlit = 0, coloured = 0;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    const SortScene scene = numbered(seed);
    const std::vector<Part> parts = lit_parts(scene);
    for (const SortPolygon& polygon : scene) {
      for (int i = 0; i < oracle::kSortColumns * oracle::kSortLines; i += 37) {
        const AreaPoint p{oracle::kSortUnits * (i % oracle::kSortColumns) + oracle::kSortUnits / 2,
                          oracle::kSortUnits * (i / oracle::kSortColumns) + oracle::kSortUnits / 2};
        bool on = false;
        if (!oracle::covers(polygon.region, {2 * p.x, 2 * p.y}, on)) continue;
        const Ray ray = shadow_ray(scene, polygon, p);
        const AreaPoint own = own_place(polygon.source, p);
        int found = 0;
        std::vector<std::uint16_t> films;
        for (const Part& part : parts) {
          if (part.source != polygon.source || !oracle::covers(part.region, {2 * own.x, 2 * own.y}, on)) continue;
          ++found;
          films = part.films;
        }
        std::sort(films.begin(), films.end());
        ++looked;
        unlit += !ray.lit;
        coloured += ray.lit && !ray.films.empty();
        const bool agrees = ray.lit ? found == 1 && films == ray.films : found == 0;
        ASSERT_TRUE(agrees || near_an_edge(scene, parts, polygon.source, p))
            << "seed " << seed << ", polygon " << polygon.source << " at " << p.x << ", " << p.y << ": " << found;
      }
    }
  }
  EXPECT_GT(unlit, looked / 10);
  EXPECT_GT(coloured, looked / 20);
}

TEST(LightView, ACarrierTakesCornersToTheirOwnPlacesExactly) {
  Carrier carrier;
  const GridPoint seen[] = {{-32000, 5}, {31000, -7}, {200, 31999}}, own[] = {{7, 7}, {-30000, 30000}, {29999, -12345}};
  for (int i = 0; i < 3; ++i) carrier.corner(seen[i], own[i]);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(carrier(seen[i]), own[i]);
  EXPECT_FALSE(carrier.flat());
  Carrier along;
  for (const std::int16_t x : {std::int16_t{0}, std::int16_t{0}, std::int16_t{5}, std::int16_t{9}})
    along.corner({x, x}, {x, 0});
  EXPECT_TRUE(along.flat());
}

}  // namespace
}  // namespace spanline::area::test
