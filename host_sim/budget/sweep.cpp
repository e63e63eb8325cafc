#include "budget/sweep.hpp"

#include <algorithm>

#include "assetc/compile.hpp"
#include "assetc/input_error.hpp"
#include "core/frame/storage.hpp"
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

template <typename Block>
std::uint32_t pool_bytes(std::uint32_t capacity) {
  return (capacity + 1) * static_cast<std::uint32_t>(sizeof(Block));
}

constexpr std::uint32_t kLayerBytes = 24;  // on a board, where a pointer has four

std::uint32_t layer_bytes(const Budget& b) {
  if (b.layers == 0) return 0;
  return pool_bytes<PolygonLook>(b.polygons) + pool_bytes<ActiveSegment>(b.layers) + (b.layers + 1) * kLayerBytes;
}

// The other blocks hold no pointers: they are as large on a board.
std::uint32_t bytes_of(const Budget& b) {
  return pool_bytes<WaitingFacet>(b.facets) + pool_bytes<std::uint16_t>(b.height) +
         pool_bytes<ScreenPoint>(b.vertices) + pool_bytes<PolygonBlock>(b.polygons) + pool_bytes<EdgeBlock>(b.edges) +
         pool_bytes<SegmentBlock>(b.segments) + (b.gouraud ? pool_bytes<SegmentShade>(b.segments) : 0) +
         pool_bytes<ActiveSegment>(b.active) + 2 * pool_bytes<std::int16_t>(b.samples) +
         pool_bytes<ImpliedEdge>(b.implied) + layer_bytes(b) + 2 * bytes_per_line(b.format, b.width);
}

SweepRow draw_with(CompiledScene& scene, const Budget& budget, unsigned percent, std::int64_t frames) {
  SweepRow row{budget, percent, bytes_of(budget), 0, {}};
  row.work.pixels = std::uint64_t{budget.width} * budget.height;
  const PoolSizes ample;
  EngineOptions options;
  options.width = budget.width;
  options.height = budget.height;
  options.observe = true;
  options.pools = pools_of(budget);
  options.pools.curves = ample.curves;  // a fitted budget says nothing of curves
  options.pools.strands = ample.strands;
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
    row.work.references = std::max<std::uint64_t>(row.work.references, rendering.statistics.segment_references);
    row.work.faces_again =
        std::max<std::uint64_t>(row.work.faces_again, std::uint64_t{view.face_count()} * (row.bands - 1));
  }
  return row;
}

Budget fitted_at(const SceneDescription& scene, Size size, std::int64_t frames) {
  SceneDescription resized = scene;
  resized.width = size.width;
  resized.height = size.height;
  CompiledScene compiled = compile(resized);
  return fitted_budget(compiled, 0, std::min(frames, kMostFrames) - 1);
}

Budget with_margin(Budget budget) {
  for (std::uint16_t* pool : {&budget.facets, &budget.vertices, &budget.polygons, &budget.edges, &budget.segments,
                              &budget.active, &budget.samples, &budget.implied, &budget.layers}) {
    *pool = static_cast<std::uint16_t>(std::min<std::uint32_t>(65534, *pool + (*pool * kMarginPercent + 99) / 100));
  }
  return budget;
}

}  // namespace

Sweep sweep(const SceneDescription& scene) {
  const std::int64_t frames = frames_of(scene);
  Sweep result{{}, with_margin(fitted_at(scene, {scene.width, scene.height}, frames)), kMarginPercent};
  for (const Size& size : kDisplays) {
    const Budget fitted = fitted_at(scene, size, frames);
    SceneDescription resized = scene;
    resized.width = size.width;
    resized.height = size.height;
    CompiledScene compiled = compile(resized);
    for (const unsigned percent : kPoolPercents) {
      result.rows.push_back(draw_with(compiled, shrunk(fitted, percent), percent, frames));
    }
  }
  return result;
}

}  // namespace spanline::host
