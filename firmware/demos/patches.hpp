// The Utah teapot as Newell made it, 32 Bezier patches of 16 control points: diced anew for every picture, so its
// outline is smooth on any screen. Backs are left out, so that the edge walker draws it.
#pragma once

#include "demos/demo.hpp"
#include "demos/teapot.hpp"
#include "patches_scene.hpp"
#include "patches_small_scene.hpp"
#include "patches_square_scene.hpp"

namespace spanline::demos {

inline constexpr Layouts::Layout kPatchesLarge{{&patches_scene::scene, &patches_scene::camera, &patches_scene::kTarget,
                                                patches_scene::kOrigins, patches_scene::kWidth, patches_scene::kHeight},
                                               {.facets = 0,
                                                .vertices = 0,
                                                .edges = 80,
                                                .patch_grid = 1700,
                                                .walker = Walker::edges,
                                                .scan_out = ScanPolicy::tiles}};

inline constexpr Layouts patches{
    "patches",
    pose_teapot,
    kPatchesLarge,
    kPatchesLarge,
    {{&patches_square_scene::scene, &patches_square_scene::camera, &patches_square_scene::kTarget,
      patches_square_scene::kOrigins, patches_square_scene::kWidth, patches_square_scene::kHeight},
     kPatchesLarge.budget},
    {{&patches_small_scene::scene, &patches_small_scene::camera, &patches_small_scene::kTarget,
      patches_small_scene::kOrigins, patches_small_scene::kWidth, patches_small_scene::kHeight},
     {.facets = 0, .vertices = 0, .edges = 60, .patch_grid = 600, .gouraud = false, .walker = Walker::edges}}};

}  // namespace spanline::demos
