// A gear of 20 teeth drives one of 12: concave faces, round holes, and teeth that fit into gaps.
#pragma once

#include "demos/demo.hpp"
#include "gears_scene.hpp"
#include "gears_small_scene.hpp"
#include "gears_square_scene.hpp"
#include "gears_tall_scene.hpp"

namespace spanline::demos {

void pose_gears(std::uint32_t frame, const Shot& shot, const Moving& moving);

// Of every layout but the small one.
inline constexpr Budget kGearsLarge{.facets = 2516,
                                    .vertices = 1240,
                                    .edges = 176,
                                    .gouraud = false,
                                    .walker = Walker::edges,
                                    .scan_out = ScanPolicy::tiles};

inline constexpr Layouts gears{"gears",
                               pose_gears,
                               {{&gears_scene::scene, &gears_scene::camera, &gears_scene::kTarget,
                                 gears_scene::kOrigins, gears_scene::kWidth, gears_scene::kHeight},
                                kGearsLarge},
                               {{&gears_tall_scene::scene, &gears_tall_scene::camera, &gears_tall_scene::kTarget,
                                 gears_tall_scene::kOrigins, gears_tall_scene::kWidth, gears_tall_scene::kHeight},
                                kGearsLarge},
                               {{&gears_square_scene::scene, &gears_square_scene::camera, &gears_square_scene::kTarget,
                                 gears_square_scene::kOrigins, gears_square_scene::kWidth, gears_square_scene::kHeight},
                                kGearsLarge},
                               {{&gears_small_scene::scene, &gears_small_scene::camera, &gears_small_scene::kTarget,
                                 gears_small_scene::kOrigins, gears_small_scene::kWidth, gears_small_scene::kHeight},
                                {.facets = 336,
                                 .vertices = 1240,
                                 .polygons = 64,
                                 .edges = 224,
                                 .segments = 72,
                                 .samples = 32,
                                 .implied = 8,
                                 .gouraud = false,
                                 .scan_out = ScanPolicy::tiles}}};

}  // namespace spanline::demos
