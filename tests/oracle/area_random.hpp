// Random regions for the clipper on a coarse lattice, so that vertices on edges, vertices on vertices, shared, opposed
// and identical edges abound.
#pragma once

#include "oracle/area_measure.hpp"
#include "oracle/random.hpp"

namespace spanline::oracle {

struct AreaPair {
  AreaRegion subject, clip;
};

// Stars, combs, spirals, nested holes, grids of cells that share edges, wild closed paths, and several of them in one
// region; now and then the clip polygon is the subject itself, reversed, shifted or mirrored.
AreaPair random_area_pair(std::uint64_t seed);

}  // namespace spanline::oracle
