// The Utah teapot as Newell made it, 32 Bezier patches of 16 control points: diced anew for every picture, so its
// outline is smooth on any screen. Spout and lid let one see inside.
#pragma once

#include "demos/demo.hpp"
#include "demos/teapot.hpp"
#include "patches_scene.hpp"
#include "patches_small_scene.hpp"
#include "patches_square_scene.hpp"

namespace spanline::demos {

inline constexpr Layouts::Layout kPatchesLarge{{&patches_scene::scene, &patches_scene::camera, &patches_scene::kTarget,
                                                patches_scene::kOrigins, patches_scene::kWidth, patches_scene::kHeight},
                                               {.facets = 400,
                                                .vertices = 0,
                                                .polygons = 128,
                                                .edges = 64,
                                                .segments = 128,
                                                .active = 24,
                                                .samples = 48,
                                                .implied = 8,
                                                .patch_facets = 400,
                                                .patch_vertices = 640}};

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
     {.facets = 80,
      .vertices = 0,
      .polygons = 80,
      .edges = 16,
      .segments = 80,
      .active = 12,
      .samples = 32,
      .implied = 0,
      .patch_facets = 80,
      .patch_vertices = 244,
      .gouraud = false}}};

}  // namespace spanline::demos
