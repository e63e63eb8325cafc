// The counters of seed 1, Fig. 33, and the pools' high-water marks. Compiled out unless VsgOptions::statistics is set.
#pragma once

#include <cstdint>
#include <type_traits>

namespace spanline {

struct Statistics {
  std::uint32_t edge_crossings = 0;      // N: two for every live segment and line
  std::uint32_t implied_edges = 0;       // implied edges created
  std::uint32_t output_segments = 0;     // visible runs on every line, background runs too
  std::uint32_t segment_blocks = 0;      // blocks ever taken from the segment pool
  std::uint32_t segment_references = 0;  // M: reads and writes of segment blocks
  std::uint32_t active_references =
      0;                          // entries of the active list looked at again in a later span: no segment block's
  std::uint32_t depth_tests = 0;  // segments loaded into the comparator, the first of a span too
  std::uint32_t comparator_cycles = 0;  // add cycles, the load included
  std::uint32_t appended = 0;           // insertions at the end of the next X-sort list
  std::uint32_t searched_back = 0;      // insertions that had to search back
  std::uint32_t samples_dropped = 0;    // hints lost to a full pool
  std::uint32_t implied_dropped = 0;
  std::uint32_t facets_left_out = 0;  // facets that one line had no room for
  std::uint32_t bands = 0;            // bands prepared, those that overflowed not counted
  std::uint32_t points_emitted = 0;   // vertices of patches computed, over all bands
  // High-water marks of the pools.
  std::uint32_t max_facets = 0, max_vertices = 0, max_polygons = 0, max_edges = 0, max_segments = 0, max_active = 0,
                max_samples = 0, max_implied = 0, max_layers = 0, max_patch_facets = 0, max_patch_vertices = 0,
                max_patch_grid = 0;
};

// What is left of them otherwise: the comparators always have somewhere to count.
struct NoStatistics {
  std::uint32_t comparator_cycles = 0;
};

template <bool kCount>
using Counters = std::conditional_t<kCount, Statistics, NoStatistics>;

}  // namespace spanline
