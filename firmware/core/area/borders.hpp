// Borders of polygons as lists of directed edges: what the area sort keeps of every polygon and piece.
#pragma once

#include "core/area/predicates.hpp"
#include "core/base/pool.hpp"

namespace spanline::area {

// An edge of a border. Where a border has been through the clipper its contours follow one another, each in order and
// with the inside to its right, and a main contour comes before its holes; before that edges stand in any order and
// the region is even-odd.
struct BorderEdge {
  GridPoint from, to;
  std::uint16_t next;
};

// A list of edges in order.
struct Border {
  std::uint16_t first = 0, last = 0;
};

struct Box {
  GridPoint low, high;  // both included

  // Nothing, ready to be widened.
  static constexpr Box none() { return {{kMaxCoordinate, kMaxCoordinate}, {-kMaxCoordinate, -kMaxCoordinate}}; }
  static constexpr Box all() { return {{-kMaxCoordinate, -kMaxCoordinate}, {kMaxCoordinate, kMaxCoordinate}}; }
  constexpr void widen(GridPoint p) {
    if (p.x < low.x) low.x = p.x;
    if (p.y < low.y) low.y = p.y;
    if (p.x > high.x) high.x = p.x;
    if (p.y > high.y) high.y = p.y;
  }
  // Whether both share more than a border.
  constexpr bool overlaps(const Box& o) const {
    return low.x < o.high.x && o.low.x < high.x && low.y < o.high.y && o.low.y < high.y;
  }
  constexpr bool holds(const Box& o) const {
    return low.x <= o.low.x && o.high.x <= high.x && low.y <= o.low.y && o.high.y <= high.y;
  }
};

// The store of all borders. Overflow is sticky: once the pool is empty edges are lost and full() is true.
class Borders {
 public:
  Borders() = default;
  explicit Borders(PoolRef<BorderEdge> edges) : edges_(edges) {}

  void clear() {
    edges_.clear();
    full_ = false;
    most_ = 0;
  }

  void append(Border& border, GridPoint from, GridPoint to) {
    const std::uint16_t index = edges_.take();
    if (index == 0) {
      full_ = true;
      return;
    }
    if (edges_.used() > most_) most_ = edges_.used();
    edges_[index] = {from, to, 0};
    if (border.first == 0) {
      border.first = index;
    } else {
      edges_[border.last].next = index;
    }
    border.last = index;
  }

  void release(Border& border) {
    while (border.first != 0) {
      const std::uint16_t next = edges_[border.first].next;
      edges_.give(border.first);
      border.first = next;
    }
    border.last = 0;
  }

  Border copy(const Border& border) {
    Border made;
    each(border, [&](const BorderEdge& edge) { append(made, edge.from, edge.to); });
    return made;
  }

  void join(Border& border, const Border& tail) {
    if (tail.first == 0) return;
    if (border.first == 0) {
      border = tail;
    } else {
      edges_[border.last].next = tail.first;
      border.last = tail.last;
    }
  }

  // The edges of `border` in order; the list may grow at its end meanwhile.
  template <typename Visit>
  void each(const Border& border, Visit visit) const {
    for (std::uint16_t i = border.first; i != 0; i = edges_[i].next) visit(edges_[i]);
  }

  // The ends of all edges: edges in no order need not have every corner as their `from`.
  template <typename Visit>
  void each_end(const Border& border, Visit visit) const {
    each(border, [&](const BorderEdge& edge) {
      visit(edge.from);
      visit(edge.to);
    });
  }

  // Whether the line through an edge of `border` has that border on its right, or on it, and `other` on its left, or on
  // it: then they share no more than a border. True of some edge where both are convex and apart.
  bool has_beside(const Border& border, const Border& other) const {
    for (std::uint16_t i = border.first; i != 0; i = edges_[i].next) {
      const BorderEdge& edge = edges_[i];
      if (all_from(other, [&](GridPoint p) { return orientation(edge.from, edge.to, p) >= 0; }) &&
          all_from(border, [&](GridPoint p) { return orientation(edge.from, edge.to, p) <= 0; })) {
        return true;
      }
    }
    return false;
  }

  // Whether `other` lies right of every edge of `border`, or on it: then it is in the kernel of that region.
  bool holds(const Border& border, const Border& other) const {
    for (std::uint16_t i = border.first; i != 0; i = edges_[i].next) {
      const BorderEdge& edge = edges_[i];
      if (!all_from(other, [&](GridPoint p) { return orientation(edge.from, edge.to, p) <= 0; })) return false;
    }
    return true;
  }

  Box bounds(const Border& border) const {
    Box box = Box::none();
    each_end(border, [&](GridPoint p) { box.widen(p); });
    return box;
  }

  BorderEdge& operator[](std::uint16_t index) const { return edges_[index]; }
  bool full() const { return full_; }
  std::uint16_t capacity() const { return edges_.capacity(); }
  std::uint16_t most() const { return most_; }  // edges in use at once

 private:
  template <typename Holds>
  bool all_from(const Border& border, Holds holds) const {
    for (std::uint16_t i = border.first; i != 0; i = edges_[i].next) {
      if (!holds(edges_[i].from)) return false;
    }
    return true;
  }

  FreeList<BorderEdge, &BorderEdge::next> edges_;
  bool full_ = false;
  std::uint16_t most_ = 0;
};

}  // namespace spanline::area
