// Facets on the screen, as the oracle and its random scenes have them.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/picture.hpp"

namespace spanline::oracle {

inline constexpr std::int64_t kMaxDepth = std::int64_t{1} << 26;  // 1/256 of a --screen depth unit

struct Vertex {
  int x, y;        // 1/16 px, y down, -32768 … 32767
  std::int64_t z;  // 1/256 of a --screen depth unit, larger is nearer, |z| <= kMaxDepth
};

// Regions are even-odd over all contours.
struct Facet {
  std::uint32_t face;
  std::vector<std::vector<Vertex>> contours;
  std::uint32_t parent = kNone;  // the face that this is surface detail of
  bool see_through = false;
};

}  // namespace spanline::oracle
