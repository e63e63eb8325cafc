// From the arrangement to the two lists: covers of all places, contours, holes and their main contours.
#pragma once

#include "core/area/arrangement.hpp"

namespace spanline::area {

// Which covers belong to a list: bit c stands for the Cover c.
using CoverSet = std::uint8_t;

class Tracer {
 public:
  Tracer() = default;
  explicit Tracer(const Pools& pools) : pools_(pools) {}

  // Both lists in one pass over the arrangement. The sets share no cover and leave out cover 0. False where the
  // contours pool is too small.
  bool trace(std::uint16_t nodes, std::uint16_t edges, CoverSet inside, CoverSet outside);

  std::uint16_t contours() const { return contours_; }
  std::uint16_t first(std::uint8_t list) const { return first_[list]; }

  // The half-edge after `h` along its contour.
  HalfEdge next(HalfEdge h) const { return pools_.edges[h >> 1].link[partner(h) & 1]; }
  GridPoint origin(HalfEdge h) const { return area::origin(pools_, h); }
  // Whether a half-edge starts where borders of both polygons meet.
  bool at_intersection(HalfEdge h) const { return has(h, kIntersection); }
  // 1 or 2 where `h` is part of a contour of the inside or outside list, 0 otherwise.
  std::uint8_t list_bounded_by(HalfEdge h) const;

 private:
  struct Walk {
    std::uint16_t first_contour, main;  // contours of the walk begin here; its main contour or 0
    std::uint8_t list;
  };

  bool has(HalfEdge h, Flag flag) const { return (pools_.edges[h >> 1].bits & (flag << (h & 1))) != 0; }
  void set(HalfEdge h, Flag flag) {
    pools_.edges[h >> 1].bits = static_cast<std::uint8_t>(pools_.edges[h >> 1].bits | (flag << (h & 1)));
  }
  void set_next(HalfEdge h, HalfEdge next) { pools_.edges[h >> 1].link[partner(h) & 1] = next; }
  std::uint16_t node_of(HalfEdge h) const { return pools_.edges[h >> 1].end[h & 1]; }
  Cover right(HalfEdge h) const { return pools_.edges[h >> 1].right(h & 1); }

  void find_covers();
  Cover cover_left_of(GridPoint at) const;
  Cover cover_below_first(const Node& node) const;
  void cover_around(std::uint16_t node, Cover below_first, std::uint16_t& stack);
  void link_contours(const Node& node);
  bool walk(HalfEdge start);
  bool add_contour(HalfEdge start, Walk& walk);
  void close_walk(const Walk& walk);
  std::uint16_t contour_below(std::uint16_t hole) const;
  std::uint16_t contour_through(HalfEdge h) const;
  void attach_holes();
  void chain_lists();

  Pools pools_;
  std::uint16_t nodes_ = 0, edges_ = 0, contours_ = 0;
  std::uint8_t list_of_[4] = {};     // of a Cover: 1 inside, 2 outside, 0 neither
  std::uint16_t first_[2] = {0, 0};  // first main contour of each list
};

}  // namespace spanline::area
