// One random scene drawn and judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/scene_store.hpp"
#include "vsg/drawing.hpp"

namespace spanline::test {

// Draws with `choices` and holds the picture against the oracle's. Returns what is wrong, or nothing. Besides identity
// (see oracle::compare) the depth of every right pixel must be within half a unit of the exact one: two such errors
// stay below the unit that the comparison forgives (polygons that projection has folded over themselves excepted).
std::string judge(Drawer& drawer, const SceneView& scene, const CameraRecord& camera,
                  const std::vector<oracle::Facet>& facets, const Choices& choices, std::int64_t tolerance);

// As judge for facets on the screen. Where something is wrong, the answer also holds the fewest of the facets that
// still go wrong, as text.
std::string judge_on_screen(Drawer& drawer, const std::vector<oracle::Facet>& facets, oracle::Layout layout,
                            const Choices& choices, std::int64_t tolerance);

}  // namespace spanline::test
