// Three cubes that tumble through one another while the viewer sways: the line where two faces cross is found in depth,
// line by line, and moves with every frame.
#pragma once

#include "cubes_scene.hpp"
#include "cubes_small_scene.hpp"
#include "demos/demo.hpp"

namespace spanline::demos {

void pose_cubes(std::uint32_t frame, const Shot& shot, const Moving& moving);

// Of every layout.
inline constexpr Budget kCubesBudget{.facets = 16,
                                     .vertices = 24,
                                     .polygons = 12,
                                     .edges = 16,
                                     .segments = 12,
                                     .samples = 24,
                                     .implied = 16,
                                     .gouraud = false,
                                     .scan_out = ScanPolicy::tiles};

inline constexpr Layouts::Layout kCubesLarge{{&cubes_scene::scene, &cubes_scene::camera, &cubes_scene::kTarget,
                                              cubes_scene::kOrigins, cubes_scene::kWidth, cubes_scene::kHeight},
                                             kCubesBudget};

inline constexpr Layouts cubes{"cubes",
                               pose_cubes,
                               kCubesLarge,
                               kCubesLarge,
                               kCubesLarge,
                               {{&cubes_small_scene::scene, &cubes_small_scene::camera, &cubes_small_scene::kTarget,
                                 cubes_small_scene::kOrigins, cubes_small_scene::kWidth, cubes_small_scene::kHeight},
                                kCubesBudget}};

}  // namespace spanline::demos
