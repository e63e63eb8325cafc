#include "core/frame/curve_overlay.hpp"

namespace spanline {

const CurveOverlay::Functions CurveOverlay::kPlot = {
    [](CurvePlotter& curves, const Screen& screen) { curves.open(screen); },
    [](CurvePlotter& curves, const SceneView& scene, const CameraRecord& camera, std::int32_t top,
       std::int32_t bottom) { curves.begin(scene, camera, top, bottom); },
    [](CurvePlotter& curves, std::int32_t line, Painter& painter) -> const Status& {
      curves.draw_line(line, [&](Rgb8 color, LineCoverage& coverage) { painter.cover(color, coverage); });
      return curves.status();
    }};

}  // namespace spanline
