// Frames per second of the bench scenes: whole frames in RGB565, projection to wire bytes, as a board would make them,
// by either walker.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "assetc/compile.hpp"
#include "assetc/scene_json.hpp"
#include "core/frame/frame.hpp"

namespace spanline::host {
namespace {

constexpr Budget kSegments{.facets = 2048,
                           .vertices = 1200,
                           .polygons = 192,
                           .edges = 192,
                           .segments = 192,
                           .samples = 192,
                           .implied = 64,
                           .tables = 7};
constexpr Budget kEdges{.facets = 2048, .vertices = 1200, .edges = 512, .walker = Walker::edges, .tables = 7};
constexpr Budget kFlatEdges{.facets = 2048, .vertices = 1200, .edges = 512, .gouraud = false, .walker = Walker::edges};

void reshade(SceneDescription& scene, Shading shading) {
  for (MaterialSpec& material : scene.materials) material.shading = shading;
}

// One whole frame; false where something was left out.
template <typename TheFrame>
bool make_frame(TheFrame& frame, const SceneView& scene, const CameraRecord& camera, std::vector<std::uint8_t>& line) {
  for (Band rest{0, kSegments.height}; !rest.empty();) {
    const Band band = frame.prepare(scene, camera, rest);
    if (band.empty()) return false;
    while (frame.next_line({line.data(), static_cast<std::uint32_t>(line.size())}))
      benchmark::DoNotOptimize(line.data());
    rest.top = band.bottom;
  }
  return frame.status().ok();
}

template <Budget kBudget>
void draw(benchmark::State& state, const std::string& name, Shading shading) {
  SceneDescription description = read_scene(std::string(SPANLINE_SCENES) + "/" + name);
  reshade(description, shading);
  description.width = kBudget.width;
  description.height = kBudget.height;
  const CompiledScene scene = compile(std::move(description));
  const SceneRecord record = scene.record();
  SceneView view;
  if (!SceneView::validate(record, view).ok()) return state.SkipWithError("the scene's records are wrong");
  const auto memory = std::make_unique<FrameMemory<kBudget>>();
  Frame<options_for(kBudget)> frame(memory->storage());
  std::vector<std::uint8_t> line(frame.line_bytes());
  while (state.KeepRunning()) {
    if (!make_frame(frame, view, scene.camera(), line)) return state.SkipWithError("something was left out");
  }
  state.SetItemsProcessed(state.iterations());  // items per second: frames per second
}

void segments(benchmark::State& state, const std::string& name, Shading shading) {
  draw<kSegments>(state, name, shading);
}
void edges(benchmark::State& state, const std::string& name, Shading shading) {
  if (shading == Shading::kFlat) return draw<kFlatEdges>(state, name, shading);
  draw<kEdges>(state, name, shading);
}

BENCHMARK_CAPTURE(segments, cube_flat, "S1.json", Shading::kFlat);
BENCHMARK_CAPTURE(edges, cube_flat, "S1.json", Shading::kFlat);
BENCHMARK_CAPTURE(segments, teapot_flat, "S3.json", Shading::kFlat);
BENCHMARK_CAPTURE(edges, teapot_flat, "S3.json", Shading::kFlat);
BENCHMARK_CAPTURE(segments, teapot_gouraud, "S3.json", Shading::kGouraud);
BENCHMARK_CAPTURE(edges, teapot_gouraud, "S3.json", Shading::kGouraud);
BENCHMARK_CAPTURE(segments, sheet_flat, "S4.json", Shading::kFlat);
BENCHMARK_CAPTURE(edges, sheet_flat, "S4.json", Shading::kFlat);
BENCHMARK_CAPTURE(segments, sheet_gouraud, "S4.json", Shading::kGouraud);
BENCHMARK_CAPTURE(edges, sheet_gouraud, "S4.json", Shading::kGouraud);

}  // namespace
}  // namespace spanline::host
