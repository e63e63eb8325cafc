// Instruments without a letter: dials, coloured zones and needles, all of them polygons.
#pragma once

#include "demos/demo.hpp"
#include "gauges_scene.hpp"
#include "gauges_small_scene.hpp"
#include "gauges_square_scene.hpp"
#include "gauges_tall_scene.hpp"

namespace spanline::demos {

void pose_gauges(std::uint32_t frame, const Shot& shot, const Moving& moving);

// Of every layout but the small one.
inline constexpr Budget kGaugesLarge{.facets = 1398,
                                     .vertices = 1431,
                                     .edges = 132,
                                     .walker = Walker::edges,
                                     .planes = 31,
                                     .kept_instances = 12,
                                     .scan_out = ScanPolicy::tiles};

inline constexpr Layouts gauges{
    "gauges",
    pose_gauges,
    {{&gauges_scene::scene, &gauges_scene::camera, &gauges_scene::kTarget, gauges_scene::kOrigins, gauges_scene::kWidth,
      gauges_scene::kHeight},
     kGaugesLarge},
    {{&gauges_tall_scene::scene, &gauges_tall_scene::camera, &gauges_tall_scene::kTarget, gauges_tall_scene::kOrigins,
      gauges_tall_scene::kWidth, gauges_tall_scene::kHeight},
     kGaugesLarge},
    {{&gauges_square_scene::scene, &gauges_square_scene::camera, &gauges_square_scene::kTarget,
      gauges_square_scene::kOrigins, gauges_square_scene::kWidth, gauges_square_scene::kHeight},
     kGaugesLarge},
    {{&gauges_small_scene::scene, &gauges_small_scene::camera, &gauges_small_scene::kTarget,
      gauges_small_scene::kOrigins, gauges_small_scene::kWidth, gauges_small_scene::kHeight},
     {.facets = 208,
      .vertices = 950,
      .polygons = 44,
      .edges = 240,
      .segments = 48,
      .samples = 48,
      .implied = 8,
      .scan_out = ScanPolicy::tiles}}};

}  // namespace spanline::demos
