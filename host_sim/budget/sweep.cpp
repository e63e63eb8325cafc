#include "budget/sweep.hpp"

#include <algorithm>

#include "assetc/compile.hpp"
#include "assetc/input_error.hpp"
#include "sim/engine.hpp"
#include "sim/fitted_budget.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

struct Size {
  std::uint16_t width, height;
};
constexpr Size kDisplays[] = {{128, 64}, {160, 128}, {240, 135}, {240, 240}, {320, 240}, {480, 320}};
constexpr unsigned kPoolPercents[] = {100, 75, 50, 33};
constexpr std::int64_t kMostFrames = 8;  // of an animation, evenly spread
constexpr unsigned kMarginPercent = 15;
constexpr std::uint32_t kMostBlocks = 32767;  // of any pool

std::int64_t frames_of(const SceneDescription& scene) {
  std::int64_t frames = scene.camera.motion.frames;
  for (const InstanceSpec& instance : scene.instances) {
    frames = std::max(frames, instance.motion.frames);
  }
  return frames;
}

std::uint16_t part(std::uint16_t whole, unsigned percent, std::uint16_t least) {
  return static_cast<std::uint16_t>(std::max<std::uint32_t>(least, whole * percent / 100));
}

// The pools that may be smaller than a frame needs; the others hold what one line needs.
Budget shrunk(Budget budget, unsigned percent) {
  budget.facets = part(budget.facets, percent, 1);
  budget.vertices = part(budget.vertices, percent, 0);
  return budget;
}

std::uint32_t bytes_of(const Budget& budget) {
  PoolSizes pools = pools_of(budget);
  pools.walker = budget.walker;
  pools.exact = true;
  const HostMemory memory({budget.width, budget.height, budget.format}, budget.height, pools);
  return static_cast<std::uint32_t>(memory.bytes()) + 2 * bytes_per_line(budget.format, budget.width);
}

void raise(double& most, double value) { most = std::max(most, value); }

void widen(FrameWork& work, const Statistics& counted, double faces) {
  const double crossings = counted.edge_crossings;
  raise(work.faces, faces);
  raise(work.crossings, crossings);
  raise(work.overlaps, counted.comparator_cycles - crossings / 2);
  raise(work.references, counted.segment_references);
  raise(work.faces_again, faces * (counted.bands - 1));
}

// By the segment walker, whose statistics tell what there is to do for either.
SweepRow draw_with(CompiledScene& scene, const Budget& budget, unsigned percent, std::int64_t frames) {
  SweepRow row{budget, percent, bytes_of(budget), 0, {}};
  row.work.pixels = static_cast<double>(budget.width) * budget.height;
  EngineOptions options;
  options.width = budget.width;
  options.height = budget.height;
  options.observe = true;
  if (budget.walker == Walker::segments) options.pools = pools_of(budget);
  const std::unique_ptr<Engine> engine = Engine::make(options);
  Rendering rendering;
  const std::int64_t step = std::max<std::int64_t>(1, frames / kMostFrames);
  for (std::int64_t frame = 0; frame < frames; frame += step) {
    scene.show(frame);
    const SceneRecord record = scene.record();
    const SceneView view = validated(record, scene.description().place);
    if (!engine->render(view, scene.camera(), rendering).ok() || !rendering.status.ok()) {
      row.bands = 0;
      return row;
    }
    row.bands = std::max(row.bands, rendering.statistics.bands);
    widen(row.work, rendering.statistics, view.face_count());
  }
  return row;
}

SceneDescription resized(const SceneDescription& scene, Size size) {
  SceneDescription other = scene;
  other.width = size.width;
  other.height = size.height;
  return other;
}

// Of the edge walker's pools only the edges of a line depend on the view.
Budget with_margin(Budget budget) {
  std::vector<std::uint16_t*> pools = {&budget.edges};
  if (budget.walker == Walker::segments) {
    pools.insert(pools.end(),
                 {&budget.facets, &budget.vertices, &budget.polygons, &budget.segments, &budget.active, &budget.samples,
                  &budget.implied, &budget.layers, &budget.patch_facets, &budget.patch_vertices});
  }
  for (std::uint16_t* const pool : pools) {
    *pool =
        static_cast<std::uint16_t>(std::min<std::uint32_t>(kMostBlocks, *pool + (*pool * kMarginPercent + 99) / 100));
  }
  return budget;
}

// As the edge walker wants it.
CompiledScene in_triangles(const SceneDescription& scene) {
  CompiledScene compiled = compile(scene);
  compiled.triangulate();
  return compiled;
}

Budget suggested_for(const SceneDescription& scene, std::int64_t last) {
  CompiledScene triangles = in_triangles(scene);
  if (const std::optional<Budget> edges = fitted_edge_budget(triangles, 0, last)) return with_margin(*edges);
  CompiledScene compiled = compile(scene);
  return with_margin(fitted_budget(compiled, 0, last));
}

}  // namespace

Sweep sweep(const SceneDescription& scene) {
  const std::int64_t frames = frames_of(scene), last = std::min(frames, kMostFrames) - 1;
  Sweep result{{}, suggested_for(scene, last), kMarginPercent};
  for (const Size& size : kDisplays) {
    CompiledScene triangles = in_triangles(resized(scene, size));
    if (const std::optional<Budget> edges = fitted_edge_budget(triangles, 0, last)) {
      result.rows.push_back(draw_with(triangles, *edges, kPoolPercents[0], frames));
    }
    CompiledScene compiled = compile(resized(scene, size));
    const Budget fitted = fitted_budget(compiled, 0, last);
    for (const unsigned percent : kPoolPercents) {
      result.rows.push_back(draw_with(compiled, shrunk(fitted, percent), percent, frames));
    }
  }
  return result;
}

}  // namespace spanline::host
