// The planar arrangement of both polygons' borders on the grid, by snap rounding (Hobby 1999; Guibas and Marimont
// 1998).
//
// Every vertex and every rounded intersection is a hot pixel. A segment with a rounded intersection is led through the
// centres of all hot pixels that it meets, in their order along it. That keeps the arrangement planar: contracting the
// pixels to their centres carries no vertex across a segment. Both coordinates of a segment are monotone, so the order
// of the pixels along it is the order of their centres, and no two intersections are ever compared by their fractions.
//
// An exact segment, which has no rounded intersection, stays where it is as long as no moved segment shares an
// off-centre pixel with it. The set of moved segments is closed under that rule: a moved piece stays within half a unit
// of its origin, so an exact segment could cross it only by ending in the strip between both (its end is then a hot
// pixel that the piece passes) or by meeting a pixel at the strip's end (and is moved then). Hence input without
// rounded intersections, such as the clipper's own output, is not changed at all.
#pragma once

#include "core/area/blocks.hpp"

namespace spanline::area {

// Fills pools in three steps; each returns false where a pool was too small. full() then says which.
class Arrangement {
 public:
  Arrangement() = default;
  explicit Arrangement(const Pools& pools) : pools_(pools) {}

  void clear();

  // Forgets the input edges after the first `count`.
  void drop_segments_from(std::uint16_t count) { segments_ = count; }

  // An input edge; low < high.
  bool add_segment(GridPoint low, GridPoint high, Role role);

  bool intersect();  // nodes: all vertices and intersections; which segments move
  // For borders that all belong to one region each: edges that coincide are the same edge. Before intersect().
  void merge_segments();
  // After intersect(): hands `visit` the nodes between the ends of an input edge that it is led through, in their order
  // from `from` to `to`; none where the edge stays where it is. False, and no more nodes, once `visit` returns false.
  template <typename Visit>
  bool lead(GridPoint from, GridPoint to, Visit visit) const;

  bool cut();   // edges between neighbouring nodes; what coincides is one edge, what cancels is none
  void spin();  // edges in order of their ends, and the half-edges around each node counter-clockwise

  struct Full {
    const char* pool = "";
    Segment segment{};  // what asked for more
    std::uint16_t capacity = 0;
  };
  const Full& full() const { return full_; }

  std::uint16_t segments() const { return segments_; }
  std::uint16_t nodes() const { return nodes_; }
  std::uint16_t edges() const { return edges_; }
  std::uint16_t rounded() const { return rounded_; }  // intersections that were not on the grid
  std::uint16_t moved() const;                        // segments led through hot pixels

 private:
  bool add_node(GridPoint at, bool active, const Segment& of);
  void sort_segments();
  void merge_nodes();
  bool cross(std::uint16_t one, std::uint16_t other);
  const Segment& find_segment(GridPoint low, GridPoint high) const;
  void settle();
  bool spread(Segment& segment);
  std::uint16_t first_node_from(std::int32_t x) const;
  bool meets(const Segment& segment, const Node& node) const;
  template <typename Visit>
  bool along(const Segment& segment, bool backwards, Visit visit) const;
  bool add_edge(std::uint16_t from, std::uint16_t to, const Segment& of);
  void insert_half_edge(HalfEdge h);
  bool fail(const char* pool, const Segment& of, std::uint16_t capacity);

  Pools pools_;
  Full full_;
  std::uint16_t segments_ = 0, nodes_ = 0, edges_ = 0, rounded_ = 0;
};

template <typename Visit>
bool Arrangement::lead(GridPoint from, GridPoint to, Visit visit) const {
  const bool forth = from < to;
  const Segment& segment = find_segment(forth ? from : to, forth ? to : from);
  if (segment.state == Segment::State::exact) return true;
  return along(segment, !forth, [&](std::uint16_t node) {
    const GridPoint at = pools_.nodes[node].at;
    return at == from || at == to || visit(at);
  });
}

// Visits the nodes that a segment goes through, in their order along it or against it; stops where `visit` returns
// false. The order: column by column in x, and within a column as the segment climbs or falls.
template <typename Visit>
bool Arrangement::along(const Segment& s, bool backwards, Visit visit) const {
  const bool down = (s.high.y < s.low.y) != backwards;
  const std::uint16_t end = first_node_from(s.high.x + 1), first = first_node_from(s.low.x);
  std::uint16_t left = first, right = end;  // columns not visited yet: [left, right)
  while (left < right) {
    std::uint16_t column = left, after = left;
    if (backwards) {
      after = right;
      column = static_cast<std::uint16_t>(right - 1);
      while (column > left && pools_.nodes[column - 1].at.x == pools_.nodes[column].at.x) --column;
      right = column;
    } else {
      while (after < right && pools_.nodes[after].at.x == pools_.nodes[column].at.x) ++after;
      left = after;
    }
    for (std::uint16_t i = 0; i < after - column; ++i) {
      const auto node = static_cast<std::uint16_t>(down ? after - 1 - i : column + i);
      if (meets(s, pools_.nodes[node]) && !visit(node)) return false;
    }
  }
  return true;
}

// The vertex that a half-edge starts at.
inline GridPoint origin(const Pools& pools, HalfEdge h) { return pools.nodes[pools.edges[h >> 1].end[h & 1]].at; }

}  // namespace spanline::area
