// The pieces of a frame, each by itself on this machine. What they take on a microcontroller is counted by ./dev bench.
#include <benchmark/benchmark.h>

#include <vector>

#include "core/curve/dice.hpp"
#include "core/frame/scan_out.hpp"
#include "core/geom/projection.hpp"
#include "core/shade/fill_words.hpp"
#include "core/shade/smooth_walk.hpp"
#include "core/vsg/active_edge.hpp"
#include "core/vsg/depth.hpp"
#include "oracle/random.hpp"

namespace spanline::bench {
namespace {

constexpr Screen kScreen{320, 240};
constexpr std::int64_t kMany = 1000;  // pieces an iteration

// What a piece's own time is seen by: a thousand of them an iteration, items per second.
void count_items(benchmark::State& state, std::int64_t items) { state.SetItemsProcessed(state.iterations() * items); }

oracle::Random seeded() { return oracle::Random(7); }

ScreenXY random_point(oracle::Random& random) {
  const auto at = [&](int pixels) { return static_cast<std::int16_t>(random.between(0, pixels * kSubpixels)); };
  return {at(kScreen.width), at(kScreen.height)};
}

void project_vertex(benchmark::State& state) {
  oracle::Random random = seeded();
  std::vector<Position> positions;
  for (int i = 0; i < kMany; ++i) {
    const auto at = [&] { return static_cast<std::int16_t>(random.between(-32000, 32000)); };
    positions.push_back({at(), at(), at()});
  }
  // One unit of the world to each side, three ahead.
  constexpr std::int32_t kOne = 1 << 16;
  const ClipMatrix matrix{{{kOne, 0, 0}, {0, kOne, 0}, {0, 0, kOne}}, {0, 0, 3 * kOne}};
  CameraRecord camera{};
  camera.focal = Fx12::from_int(290);
  camera.near_plane = Fx16::from_int(1);
  camera.far_plane = Fx16::from_int(9);
  camera.focal = Fx12::from_int(290);
  const Projection projection(camera, kScreen);
  const ClipRow x(matrix, 0), y(matrix, 1), w(matrix, 2);
  while (state.KeepRunning()) {
    Normaliser normaliser;
    for (const Position& p : positions) {
      benchmark::DoNotOptimize(projection.place({x.at(p), y.at(p), w.at(p)}, normaliser));
    }
  }
  count_items(state, kMany);
}
BENCHMARK(project_vertex);

template <bool kDivide>
void start_edge(benchmark::State& state) {
  oracle::Random random = seeded();
  std::vector<std::pair<ScreenXY, ScreenXY>> edges;
  while (edges.size() < kMany) {
    const ScreenXY top = random_point(random);
    const ScreenXY bottom{static_cast<std::int16_t>(top.x + random.between(-100, 100)),
                          static_cast<std::int16_t>(top.y + random.between(kSubpixels, 200))};
    edges.emplace_back(top, bottom);
  }
  while (state.KeepRunning()) {
    for (const auto& [top, bottom] : edges) {
      ActiveEdge edge{0, 0, cover_of(1), 0};
      FromVertex(PackedXY(top), first_centre(top.y)).run<kDivide>(edge, PackedXY(bottom), 0);
      benchmark::DoNotOptimize(edge);
    }
  }
  count_items(state, kMany);
}
BENCHMARK(start_edge<true>)->Name("start_edge/divided");
BENCHMARK(start_edge<false>)->Name("start_edge/by_table");

void make_depth_plane(benchmark::State& state) {
  oracle::Random random = seeded();
  struct Corners {
    ScreenXY at[3];
    std::uint32_t depth[3];
  };
  std::vector<Corners> triangles;
  while (triangles.size() < kMany) {
    Corners t{{random_point(random), random_point(random), random_point(random)}, {}};
    const int area =
        (t.at[1].x - t.at[0].x) * (t.at[2].y - t.at[0].y) - (t.at[1].y - t.at[0].y) * (t.at[2].x - t.at[0].x);
    if (area == 0) continue;
    for (std::uint32_t& depth : t.depth) depth = static_cast<std::uint32_t>(random.between(1 << 20, 1 << 23));
    triangles.push_back(t);
  }
  while (state.KeepRunning()) {
    for (const Corners& t : triangles) {
      benchmark::DoNotOptimize(depth_plane(t.at, t.depth, kScreen));
    }
  }
  count_items(state, kMany);
}
BENCHMARK(make_depth_plane);

// A line of spans as long as the argument.
template <typename Fill>
void spans(benchmark::State& state, const Fill& fill) {
  const auto length = static_cast<std::int32_t>(state.range(0));
  std::vector<std::uint32_t> line((kScreen.width + kOvershoot + 1) / 2);
  auto* const pixels = reinterpret_cast<std::uint8_t*>(line.data());
  while (state.KeepRunning()) {
    for (std::int32_t left = 0; left + length <= kScreen.width; left += length) fill(pixels, left, left + length);
    benchmark::DoNotOptimize(line.data());
    benchmark::ClobberMemory();
  }
  count_items(state, kScreen.width);  // pixels
}

void fill_flat(benchmark::State& state) {
  spans(state, [](std::uint8_t* line, std::int32_t left, std::int32_t right) { fill_span(line, left, right, 0x1234); });
}
BENCHMARK(fill_flat)->Arg(5)->Arg(20)->Arg(80)->Arg(320);

void fill_smooth(benchmark::State& state) {
  const ScreenXY at[3] = {{0, 0}, {320 * kSubpixels, 100}, {50, 240 * kSubpixels}};
  const Brightness level[3] = {10, 200, 90};
  const BrightnessPlane plane = brightness_plane(at, level);
  const std::vector<std::uint16_t> colors(256, 0x4321);
  spans(state, [&](std::uint8_t* line, std::int32_t left, std::int32_t right) {
    smooth_span(line, left, right, plane, 20, colors.data());
  });
}
BENCHMARK(fill_smooth)->Arg(5)->Arg(20)->Arg(80)->Arg(320);

void dice_patch(benchmark::State& state) {
  // A dome three units ahead whose middle bulges towards the viewer; clip units of the guard band.
  ClipPatch patch;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const bool inner = i % 3 != 0 && j % 3 != 0;
      patch.at[i][j] = {(2 * j - 3) * 6000, (2 * i - 3) * 6000, (inner ? 2 : 3) << 16};
    }
  }
  CameraRecord camera{};
  camera.near_plane = Fx16::from_int(1);
  camera.far_plane = Fx16::from_int(9);
  camera.focal = Fx12::from_int(290);
  const DiceView view(camera, kScreen, 8);
  std::vector<ClipPoint> above(kMaxSteps + 1), below(kMaxSteps + 1);
  const auto row = [](std::vector<ClipPoint>& points) {
    return Slice<ClipPoint>(points.data(), static_cast<std::uint32_t>(points.size()));
  };
  std::int64_t facets = 0;
  while (state.KeepRunning()) {
    dice(patch, view, row(above), row(below), [&](const PatchFacet& facet) {
      benchmark::DoNotOptimize(facet);
      ++facets;
    });
  }
  state.SetItemsProcessed(facets);
}
BENCHMARK(dice_patch);

// What is known of the panel is asked line by line; half of a line changes with each frame.
void scan_out(benchmark::State& state, ScanPolicy policy) {
  std::vector<Columns> lines(kScreen.height);
  std::vector<std::uint32_t> hashes(tiles_per_line(kScreen.width) * kScreen.height);
  ScanOut out(
      {kScreen, policy, {lines.data(), kScreen.height}, {hashes.data(), static_cast<std::uint32_t>(hashes.size())}});
  std::vector<std::uint32_t> words(kScreen.width / 2);
  std::uint32_t frame = 0;
  while (state.KeepRunning()) {
    ++frame;
    for (std::size_t i = words.size() / 4; i < words.size() * 3 / 4; ++i)
      words[i] = frame * static_cast<std::uint32_t>(i);
    out.begin_frame({});
    for (std::uint16_t line = 0; line < kScreen.height; ++line) {
      out.line(line, {reinterpret_cast<const std::uint8_t*>(words.data()), kScreen.width * 2u});
      for (PixelRun run; out.next(run);) benchmark::DoNotOptimize(run);
    }
  }
  count_items(state, kScreen.height);  // lines
}
BENCHMARK_CAPTURE(scan_out, extents, ScanPolicy::extents);
BENCHMARK_CAPTURE(scan_out, tiles, ScanPolicy::tiles);

}  // namespace
}  // namespace spanline::bench
