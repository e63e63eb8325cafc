// The curves of a scene over its faces.
#pragma once

#include "core/curve/plotter.hpp"
#include "core/shade/painter.hpp"

namespace spanline {

// A plotter behind a table of functions, so that only a budget with strands links what draws curves.
struct CurveOverlay {
  struct Functions {
    void (*open)(CurvePlotter& plotter, const Screen& screen);
    void (*begin)(CurvePlotter& plotter, const SceneView& scene, const CameraRecord& camera, std::int32_t top,
                  std::int32_t bottom);                                                 // CurvePlotter::begin
    const Status& (*draw)(CurvePlotter& plotter, std::int32_t line, Painter& painter);  // over the line just painted
  };
  static const Functions kPlot;

  const Functions* functions = nullptr;
  CurvePlotter plotter;

  // Works in these pools from now on.
  void use(const CurveStorage& storage) {
    functions = &kPlot;
    plotter.use(storage);
  }
};

// The curves of one frame, or none.
class CurveLayer {
 public:
  // `overlay` may be null: then curves are not drawn.
  CurveLayer(CurveOverlay* overlay, const Screen& screen) : overlay_(overlay) {
    if (overlay_ != nullptr) overlay_->functions->open(overlay_->plotter, screen);
  }

  // The lines to come. The status is pool_exhausted where the scene has curves and there is nothing to draw them with.
  const Status& begin(const SceneView& scene, const CameraRecord& camera, std::int32_t top, std::int32_t bottom) {
    if (overlay_ == nullptr) return scene.curve_count() == 0 ? kDone : kNoStrands;
    overlay_->functions->begin(overlay_->plotter, scene, camera, top, bottom);
    return kDone;
  }

  // Draws over a line that is painted. The status is that of the frame so far.
  const Status& draw(std::int32_t line, Painter& painter) {
    return overlay_ == nullptr ? kDone : overlay_->functions->draw(overlay_->plotter, line, painter);
  }

 private:
  static constexpr Status kDone{}, kNoStrands{Code::pool_exhausted, "strands", "", 0, 0, 1, 0};

  CurveOverlay* overlay_;
};

// Where scenes have no curves.
struct NoCurveLayer {
  constexpr NoCurveLayer(CurveOverlay*, const Screen&) {}
};

}  // namespace spanline
