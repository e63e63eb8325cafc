// A house in lines, as a pen plotter draws it: what is hidden is taken away by core/area on the board itself.
#pragma once

#include "demos/demo.hpp"
#include "demos/still_life.hpp"
#include "plot_scene.hpp"
#include "plot_small_scene.hpp"

namespace spanline::demos {

inline constexpr Budget kPlotBudget{
    .facets = 64, .vertices = 128, .polygons = 48, .edges = 640, .segments = 96, .lines = 768};

inline constexpr Layouts::Layout kPlot{{&plot_scene::scene, &plot_scene::camera, &plot_scene::kTarget,
                                        plot_scene::kOrigins, plot_scene::kWidth, plot_scene::kHeight},
                                       kPlotBudget};
inline constexpr Layouts::Layout kPlotSmall{
    {&plot_small_scene::scene, &plot_small_scene::camera, &plot_small_scene::kTarget, plot_small_scene::kOrigins,
     plot_small_scene::kWidth, plot_small_scene::kHeight},
    kPlotBudget};

inline constexpr Layouts plot{"plot", pose_still_life, kPlot, kPlot, kPlot, kPlotSmall};

}  // namespace spanline::demos
