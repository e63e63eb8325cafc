// Which faces of a scene belong to one convex solid, or to an open part of one: all of it lies behind each of them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/format.hpp"

namespace spanline::host {

struct SolidFace {
  std::uint32_t instance;
  std::vector<Position> corners;  // counter-clockwise from outside; the first ring, then the others
};

inline constexpr std::int32_t kNoSolid = -1;

// Of each face its solid, or kNoSolid: connected faces of one instance share corners. A corner counts as behind a plane
// where rounding may have lifted it above.
std::vector<std::int32_t> convex_solids(const std::vector<SolidFace>& faces);

}  // namespace spanline::host
