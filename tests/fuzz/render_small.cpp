#include "fuzz/render_small.hpp"

#include "assetc/compile.hpp"
#include "sim/engine.hpp"

namespace spanline::host {
namespace {

EngineOptions small(Comparator comparator) {
  EngineOptions options;
  options.width = 48;
  options.height = 32;
  options.comparator = comparator;
  options.pools = {.facets = 4096,
                   .vertices = 4096,
                   .polygons = 1024,
                   .edges = 1024,
                   .segments = 2048,
                   .samples = 512,
                   .implied = 512,
                   .patch_facets = 8192,
                   .patch_vertices = 12000};
  return options;
}

void compare_frames(const CompiledScene& scene) {
  const SceneRecord record = scene.record();
  SceneView view;
  if (!SceneView::validate(record, view).ok()) __builtin_trap();
  Rendering plane, midpoint;
  EngineOptions frugal = small(Comparator::midpoint);
  frugal.bands = 3;
  frugal.pools.edges = 4;
  frugal.pools.vertices = frugal.pools.samples = frugal.pools.implied = 3;
  const Status a = Engine::make(small(Comparator::plane))->render(view, scene.camera(), plane);
  const Status b = Engine::make(frugal)->render(view, scene.camera(), midpoint);
  if (!a.ok() || !b.ok() || !plane.status.ok() || !midpoint.status.ok()) return;
  if (plane.picture.rgb != midpoint.picture.rgb) __builtin_trap();
}

// Patches as points, in one band and in several.
void compare_points(const CompiledScene& scene) {
  const SceneRecord record = scene.record();
  SceneView view;
  if (!SceneView::validate(record, view).ok()) __builtin_trap();
  if (view.layered() || !view.has_patches()) return;
  EngineOptions whole = small(Comparator::plane);
  whole.surface = Surface::points;
  EngineOptions frugal = whole;
  frugal.pools.point_lines = 5;
  Rendering one, several;
  const Status a = Engine::make(whole)->render(view, scene.camera(), one);
  const Status b = Engine::make(frugal)->render(view, scene.camera(), several);
  if (a.ok() != b.ok()) __builtin_trap();
  if (a.ok() && one.status.ok() && several.status.ok() && one.picture.rgb != several.picture.rgb) __builtin_trap();
}

}  // namespace

void render_small(SceneDescription description) {
  description.width = 48;
  description.height = 32;
  CompiledScene scene = compile(std::move(description));
  for (const std::int64_t frame : {0, 3}) {
    scene.show(frame);
    compare_frames(scene);
    compare_points(scene);
  }
}

}  // namespace spanline::host
