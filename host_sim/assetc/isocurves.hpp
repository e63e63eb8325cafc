#pragma once

#include <array>
#include <vector>

#include "assetc/bpt.hpp"

namespace spanline::host {

using BezierPoints = std::array<Vec3, 4>;

// Curves of constant u and of constant v on Bezier patches: on each patch those at u = 0, 1 / across, … 1, and likewise
// `down` in v. Curves that neighbours share come once, and those that are a single point not at all.
std::vector<BezierPoints> isocurves(const std::vector<BptPatch>& patches, int across, int down);

}  // namespace spanline::host
