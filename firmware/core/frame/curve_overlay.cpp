#include "core/frame/curve_overlay.hpp"

namespace spanline {

const CurveOverlay::Functions CurveOverlay::kPlot = {
    [](CurvePlotter& plotter, const Screen& screen) { plotter.open(screen); },
    [](CurvePlotter& plotter, const SceneView& scene, const CameraRecord& camera, std::int32_t top,
       std::int32_t bottom) { plotter.begin(scene, camera, top, bottom); },
    [](CurvePlotter& plotter, std::int32_t line, Painter& painter) -> const Status& {
      plotter.draw_line(line, [&](Rgb8 color, LineCoverage& coverage) { painter.cover(color, coverage); });
      return plotter.status();
    }};

}  // namespace spanline
