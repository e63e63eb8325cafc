// What the clipper stores, and the pools it stores it in. All blocks are named by 16-bit indices from 1; 0 is none.
#pragma once

#include <cstdint>

#include "core/area/predicates.hpp"
#include "core/base/pool.hpp"

namespace spanline::area {

enum class Role : std::uint8_t { subject, clip };

// An input edge, from its lesser to its greater end.
struct Segment {
  GridPoint low, high;
  Role role;
  // Exact segments keep every grid point of theirs; the others are led through the centres of all hot pixels they meet.
  enum class State : std::uint8_t { exact, moved, spread } state;
};

// A vertex of the arrangement.
struct Node {
  GridPoint at;
  std::uint16_t first;  // the half-edge that comes first counter-clockwise from straight down
  std::uint16_t mark;   // each stage's own
};

// Half-edges are named 2 · edge + direction; direction 0 starts at end[0], the lesser end.
using HalfEdge = std::uint16_t;
constexpr HalfEdge partner(HalfEdge h) { return h ^ 1u; }

// Which polygons cover a place: bit 0 the subject, bit 1 the clip polygon.
using Cover = std::uint8_t;
constexpr Cover cover_of(Role role) { return role == Role::subject ? 1 : 2; }

// An edge of the arrangement.
struct Edge {
  std::uint16_t end[2];   // nodes
  std::uint16_t link[2];  // by direction: next half-edge counter-clockwise around end[d]; in the traced contours the
                          // half-edge that follows the one that arrives there
  Cover borders;          // whose border it is
  std::uint8_t bits;      // bits 0 and 1: what covers the place right of direction 0; then Flag

  // What covers the place right of a direction: to cross the edge is to enter or leave those whose border it is.
  Cover right(unsigned direction) const {
    return static_cast<Cover>((bits & 3u) ^ (direction == 0 ? 0u : static_cast<unsigned>(borders)));
  }
};

// Bits of Edge::bits. Those of a direction are shifted left by it.
enum Flag : std::uint8_t { kKnown = 4, kTraced = 8, kIntersection = 32 };

// A contour of the output.
struct Contour {
  HalfEdge first;          // the one that starts at the contour's least vertex
  std::uint16_t relation;  // of a hole: its main contour; of a main contour: its first hole, or 0
  std::uint16_t next;      // the next main contour of the list, or the next hole of the same main contour
  std::uint8_t list;       // 0 inside, 1 outside
  bool hole;
};

// What the algorithms take of somebody's pools.
struct Pools {
  PoolRef<Segment> segments;  // input edges
  PoolRef<Node> nodes;        // distinct vertices and intersections
  PoolRef<Edge> edges;        // distinct edges between neighbouring nodes; at most kMaxEdges
  PoolRef<Contour> contours;  // of the output
};

inline constexpr std::uint16_t kMaxEdges = UINT16_MAX / 2 - 1;  // half-edges are 16-bit indices, and UINT16_MAX is none

// The owner.
template <std::uint16_t kSegments, std::uint16_t kNodes, std::uint16_t kEdges, std::uint16_t kContours>
struct PoolStorage {
  static_assert(kEdges <= kMaxEdges);
  Pool<Segment, kSegments> segments;
  Pool<Node, kNodes> nodes;
  Pool<Edge, kEdges> edges;
  Pool<Contour, kContours> contours;
  Pools refs() { return {segments.ref(), nodes.ref(), edges.ref(), contours.ref()}; }
};

}  // namespace spanline::area
