// What a pixel shows where there are surface detail and see-through polygons: the slow twin of the engine's layers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "oracle/renderer.hpp"

namespace spanline::oracle {

// The facets by face.
using FacetsByFace = std::map<std::uint32_t, const Facet*>;
FacetsByFace by_face(const std::vector<Facet>& facets);

// The faces that a pixel shows, the nearest first, from its exact candidates: see-through surfaces in front of the
// nearest opaque one, and that; for each the topmost detail that covers the pixel instead, and nothing behind an opaque
// detail. Nearer wins, equal depths go to the lower face.
std::vector<std::uint32_t> stack_of(const std::vector<Candidate>& candidates, const FacetsByFace& facets);

// Why `drawn` cannot be what the pixel shows; empty where it can. Surfaces closer than `tolerance` (1/256 unit) may
// stand in either order; detail and coverage are exact.
std::string wrong_stack(const std::vector<std::uint32_t>& drawn, const std::vector<Candidate>& candidates,
                        const FacetsByFace& facets, std::int64_t tolerance);

}  // namespace spanline::oracle
