// The screen facets that geom hands out, as the oracle takes them: where the random camera scenes are compared from.
#pragma once

#include <vector>

#include "core/geom/facet.hpp"
#include "oracle/renderer.hpp"

namespace spanline::test {

// Every face that is drawn, after culling and clipping.
std::vector<oracle::Facet> facets_of(const SceneView& scene, const CameraRecord& camera, const Screen& screen);

// The material of every face, by number.
std::vector<MaterialRecord> materials_of(const SceneView& scene, const CameraRecord& camera, const Screen& screen);

}  // namespace spanline::test
