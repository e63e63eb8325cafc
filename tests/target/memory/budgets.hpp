// What a teapot of 992 triangles and a closed ring of 1,000 are drawn in: flat, 320 x 240 RGB565. memory.sh holds the
// sums to these names.
#pragma once

#include "core/frame/budget.hpp"

namespace spanline::target {

// Every vertex projected once, the picture in one band.
inline constexpr Budget k16K{.facets = 456,
                             .vertices = 530,
                             .polygons = 56,
                             .edges = 24,
                             .segments = 56,
                             .active = 12,
                             .samples = 40,
                             .implied = 2,
                             .gouraud = false};

// No vertex kept, bands of a few lines: what one line needs, and little else.
inline constexpr Budget k8K{.band_lines = 4,
                            .facets = 51,
                            .vertices = 0,
                            .polygons = 51,
                            .edges = 2,
                            .segments = 51,
                            .active = 5,
                            .samples = 2,
                            .implied = 0,
                            .gouraud = false};

}  // namespace spanline::target
