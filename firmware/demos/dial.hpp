// One instrument out of curves: strokes of a constant width, anti-aliased, on a face and figures with curved outlines.
#pragma once

#include "demos/demo.hpp"
#include "dial_scene.hpp"
#include "dial_small_scene.hpp"

namespace spanline::demos {

void pose_dial(std::uint32_t frame, const Shot& shot, const Moving& moving);

inline constexpr Layouts::Layout kDialLarge{{&dial_scene::scene, &dial_scene::camera, &dial_scene::kTarget,
                                             dial_scene::kOrigins, dial_scene::kWidth, dial_scene::kHeight},
                                            {.facets = 4,
                                             .vertices = 328,
                                             .polygons = 4,
                                             .edges = 128,
                                             .segments = 8,
                                             .samples = 20,
                                             .implied = 0,
                                             .curves = 96,
                                             .strands = 16,
                                             .gouraud = false,
                                             .kept_instances = 2,
                                             .scan_out = ScanPolicy::tiles}};

inline constexpr Layouts dial{"dial",
                              pose_dial,
                              kDialLarge,
                              kDialLarge,
                              kDialLarge,
                              {{&dial_small_scene::scene, &dial_small_scene::camera, &dial_small_scene::kTarget,
                                dial_small_scene::kOrigins, dial_small_scene::kWidth, dial_small_scene::kHeight},
                               {.facets = 4,
                                .vertices = 102,
                                .polygons = 4,
                                .edges = 40,
                                .segments = 8,
                                .samples = 8,
                                .implied = 0,
                                .curves = 48,
                                .strands = 12,
                                .gouraud = false,
                                .kept_instances = 2,
                                .scan_out = ScanPolicy::tiles}}};

}  // namespace spanline::demos
