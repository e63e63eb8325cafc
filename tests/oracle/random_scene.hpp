// Seeded random scenes for the comparison with the oracle.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/renderer.hpp"
#include "oracle/scene_store.hpp"

namespace spanline::oracle {

// 1 … 60 polygons on the screen, numbered from 0 in the order given, most of them on a picture of 64 x 48 px. Odd seeds
// interpenetrate, even ones lie in separate layers of depth. All kinds of random_polygon; fans and strips with shared
// edges; doubles of the same polygon; repeated corners; polygons far out of and wholly beside the picture; corners on
// pixel centres; planes, nearly planes (z rounded to units) and twisted polygons.
std::vector<Facet> random_screen_facets(std::uint64_t seed);

// As above, but every polygon lies at one depth and depths either are equal or differ by 2 units at least: identity
// must be exact, ties by face number included.
std::vector<Facet> random_level_facets(std::uint64_t seed);

// As random_screen_facets, but every second polygon has its corners anywhere and crosses itself.
std::vector<Facet> random_crossed_facets(std::uint64_t seed);

// The layout that goes with a seed.
Layout random_layout(std::uint64_t seed);

}  // namespace spanline::oracle
