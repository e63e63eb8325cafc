// The clipper beside Debian's libpolyclipping on the same random pairs, both lists computed: a well-known integer
// clipper that takes two runs for what one gives here. Polygons of N corners around one centre, and the pairs of the
// random tests.
#include <benchmark/benchmark.h>

#include <memory>
#include <polyclipping/clipper.hpp>
#include <vector>

#include "core/area/clipper.hpp"
#include "oracle/area_random.hpp"
#include "oracle/random_polygon.hpp"

namespace spanline::area {
namespace {

using oracle::AreaPair;
using oracle::AreaRegion;
using oracle::AreaRing;

constexpr int kPairs = 100;

AreaRing spiky(oracle::Random& random, int corners) {
  AreaRing ring;
  for (int i = 0; i < corners; ++i) {
    const oracle::Point p = oracle::circle_point(1024 * i / corners);
    const int radius = random.between(6000, 15000);
    ring.push_back({std::int64_t{p.x} * radius / 16384, std::int64_t{p.y} * radius / 16384});
  }
  return ring;
}

// `corners` 0: the pairs of the random tests.
std::vector<AreaPair> pairs_of(std::int64_t corners) {
  oracle::Random random(1977);
  std::vector<AreaPair> pairs;
  for (int i = 0; i < kPairs; ++i) {
    if (corners == 0) {
      pairs.push_back(oracle::random_area_pair(static_cast<std::uint64_t>(i)));
    } else {
      const int count = static_cast<int>(corners);
      pairs.push_back({{spiky(random, count)}, {spiky(random, count)}});
    }
  }
  return pairs;
}

void put(Clipper& clipper, Role role, const AreaRegion& region) {
  for (const AreaRing& ring : region) {
    clipper.begin_contour(role);
    for (const oracle::AreaPoint p : ring)
      clipper.vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
    clipper.end_contour();
  }
}

struct Counted {
  std::int64_t vertices = 0;
  void begin_polygon() {}
  void begin_contour() {}
  void vertex(std::int32_t, std::int32_t) { ++vertices; }
  void end_contour() {}
  void end_polygon() {}
};

void spanline_lists(benchmark::State& state) {
  const std::vector<AreaPair> pairs = pairs_of(state.range(0));
  const auto storage = std::make_unique<PoolStorage<4000, 20000, 30000, 4000>>();
  Clipper clipper(storage->refs());
  for (auto _ : state) {
    for (const AreaPair& pair : pairs) {
      clipper.clear();
      put(clipper, Role::subject, pair.subject);
      put(clipper, Role::clip, pair.clip);
      if (!clipper.clip().ok()) return state.SkipWithError("a pool is too small");
      Counted counted;
      clipper.read(List::inside, counted);
      clipper.read(List::outside, counted);
      benchmark::DoNotOptimize(counted.vertices);
    }
  }
  state.SetItemsProcessed(state.iterations() * kPairs);
}
BENCHMARK(spanline_lists)->Arg(0)->Arg(16)->Arg(64)->Arg(256)->Arg(1024)->Unit(benchmark::kMicrosecond);

ClipperLib::Paths paths_of(const AreaRegion& region) {
  ClipperLib::Paths paths;
  for (const AreaRing& ring : region) {
    ClipperLib::Path& path = paths.emplace_back();
    for (const oracle::AreaPoint p : ring) path.emplace_back(p.x, p.y);
  }
  return paths;
}

// Trees, for those tell holes from polygons, as the lists here do.
void polyclipping_lists(benchmark::State& state) {
  const std::vector<AreaPair> pairs = pairs_of(state.range(0));
  for (auto _ : state) {
    for (const AreaPair& pair : pairs) {
      ClipperLib::Clipper clipper;
      clipper.AddPaths(paths_of(pair.subject), ClipperLib::ptSubject, true);
      clipper.AddPaths(paths_of(pair.clip), ClipperLib::ptClip, true);
      ClipperLib::PolyTree inside, outside;
      clipper.Execute(ClipperLib::ctIntersection, inside, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
      clipper.Execute(ClipperLib::ctDifference, outside, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
      benchmark::DoNotOptimize(inside.Total() + outside.Total());
    }
  }
  state.SetItemsProcessed(state.iterations() * kPairs);
}
BENCHMARK(polyclipping_lists)->Arg(0)->Arg(16)->Arg(64)->Arg(256)->Arg(1024)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace spanline::area
