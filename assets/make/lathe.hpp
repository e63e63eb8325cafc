#pragma once

#include "mesh.hpp"

namespace spanline::make {

// A closed profile in the (radius, z) plane, material on its left, turned about the z axis in `steps` steps.
void lathe(Mesh& mesh, const std::vector<std::array<double, 2>>& profile, int steps);

}  // namespace spanline::make
