// The Utah teapot, 992 triangles with Gouraud shading, turning on its spot.
#pragma once

#include "demos/demo.hpp"
#include "teapot_scene.hpp"
#include "teapot_small_scene.hpp"

namespace spanline::demos {

void pose_teapot(std::uint32_t frame, const Demo& demo, const Moving& moving);

namespace layout {

inline constexpr Demo kTeapot{"teapot",
                              {.facets = 640, .vertices = 620, .polygons = 96, .edges = 64, .segments = 96},
                              &teapot_scene::scene,
                              &teapot_scene::camera,
                              &teapot_scene::kTarget,
                              teapot_scene::kWidth,
                              teapot_scene::kHeight,
                              pose_teapot};
inline constexpr Demo kTeapotSmall{"teapot",
                                   {.facets = 640, .vertices = 620, .polygons = 96, .edges = 64, .segments = 96},
                                   &teapot_small_scene::scene,
                                   &teapot_small_scene::camera,
                                   &teapot_small_scene::kTarget,
                                   teapot_small_scene::kWidth,
                                   teapot_small_scene::kHeight,
                                   pose_teapot};

}  // namespace layout

inline constexpr Layouts teapot{layout::kTeapot, layout::kTeapot, layout::kTeapotSmall};

}  // namespace spanline::demos
