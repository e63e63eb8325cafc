// The Utah teapot, 992 triangles with Gouraud shading, turning on its spot.
#pragma once

#include "demos/demo.hpp"
#include "teapot_scene.hpp"
#include "teapot_small_scene.hpp"
#include "teapot_square_scene.hpp"

namespace spanline::demos {

void pose_teapot(std::uint32_t frame, const Shot& shot, const Moving& moving);

inline constexpr Layouts::Layout kTeapotLarge{
    {&teapot_scene::scene, &teapot_scene::camera, &teapot_scene::kTarget, teapot_scene::kOrigins, teapot_scene::kWidth,
     teapot_scene::kHeight},
    {.facets = 992, .vertices = 530, .edges = 80, .walker = Walker::edges, .scan_out = ScanPolicy::tiles}};

inline constexpr Layouts teapot{
    "teapot",
    pose_teapot,
    kTeapotLarge,
    kTeapotLarge,
    {{&teapot_square_scene::scene, &teapot_square_scene::camera, &teapot_square_scene::kTarget,
      teapot_square_scene::kOrigins, teapot_square_scene::kWidth, teapot_square_scene::kHeight},
     kTeapotLarge.budget},
    {{&teapot_small_scene::scene, &teapot_small_scene::camera, &teapot_small_scene::kTarget,
      teapot_small_scene::kOrigins, teapot_small_scene::kWidth, teapot_small_scene::kHeight},
     {.facets = 992, .vertices = 530, .edges = 68, .walker = Walker::edges, .scan_out = ScanPolicy::tiles}}};

}  // namespace spanline::demos
