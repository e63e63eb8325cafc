#include "core/area/line_drawing.hpp"

#include "core/area/sort.hpp"

namespace spanline::area {
namespace {

// The first of the sorted blocks 1 … count that `before` does not hold of, or count + 1.
template <typename T, typename Before>
std::uint16_t first_not(PoolRef<T> items, std::uint16_t count, Before before) {
  std::uint32_t low = 1, high = count + 1u;
  while (low < high) {
    const std::uint32_t middle = (low + high) / 2;
    if (before(items[middle])) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return static_cast<std::uint16_t>(low);
}

bool same_ends(const DrawnEdge& a, const DrawnEdge& b) { return a.low == b.low && a.high == b.high; }

}  // namespace

bool LineDrawing::add(const DrawnEdge& edge) {
  if (count_ == edges_.capacity() && asked_ == 0) asked_ = edge.look;
  if (asked_ == 0) edges_[++count_] = edge;
  return asked_ == 0;
}

void LineDrawing::edge(GridPoint from, GridPoint to, std::uint16_t look) {
  if (from == to) return;
  const auto number = static_cast<std::uint16_t>(look + 1);
  if (!add(from < to ? DrawnEdge{from, to, number} : DrawnEdge{to, from, number})) return;
  // Of a closed border each corner is where one edge begins.
  if (corners_ == points_.capacity()) {
    asked_ = number;
  } else {
    points_[++corners_] = from;
  }
}

void LineDrawing::sort_edges() {
  sort_blocks(edges_, count_, [](const DrawnEdge& a, const DrawnEdge& b) {
    if (!(a.low == b.low)) return a.low < b.low;
    return !(a.high == b.high) ? a.high < b.high : a.look < b.look;
  });
}

void LineDrawing::sort_points() {
  sort_blocks(points_, corners_, [](GridPoint a, GridPoint b) { return a < b; });
  std::uint16_t kept = 0;
  for (std::uint16_t i = 1; i <= corners_; ++i) {
    if (kept == 0 || !(points_[kept] == points_[i])) points_[++kept] = points_[i];
  }
  corners_ = kept;
}

// An edge is cut where corners of others lie on it, so that both of its sides are the same pieces of border.
void LineDrawing::cut_at_corners() {
  const std::uint16_t whole = count_;
  for (std::uint16_t i = 1; i <= whole; ++i) {
    const GridPoint low = edges_[i].low, high = edges_[i].high;
    std::uint16_t at = i;
    for (std::uint32_t k = first_not(points_, corners_, [&](GridPoint p) { return p < low || p == low; });
         k <= corners_ && points_[k] < high; ++k) {
      const GridPoint corner = points_[k];
      if (!within(corner.y, low.y, high.y) || orientation(low, high, corner) != 0) continue;
      if (!add({corner, high, edges_[i].look})) return;
      edges_[at].high = corner;
      at = count_;
    }
  }
}

// Of each run of edges with the same ends one is kept where it bounds somebody: who has it twice lies on both sides.
void LineDrawing::keep_borders() {
  std::uint16_t kept = 0;
  for (std::uint32_t i = 1; i <= count_;) {
    const DrawnEdge edge = edges_[i];
    bool bounds = false;
    while (i <= count_ && same_ends(edge, edges_[i])) {
      const std::uint16_t look = edges_[i].look;
      const std::uint32_t first = i;
      while (i <= count_ && same_ends(edge, edges_[i]) && edges_[i].look == look) ++i;
      bounds |= (i - first) % 2 != 0;
    }
    if (bounds) edges_[++kept] = edge;
  }
  count_ = kept;
}

// Edges that follow one another straight on become one.
void LineDrawing::join() {
  for (std::uint16_t i = 1; i <= count_; ++i) {
    DrawnEdge& line = edges_[i];
    if (line.look == 0) continue;
    for (bool grown = true; grown;) {
      grown = false;
      const std::uint16_t first = first_not(edges_, count_, [&](const DrawnEdge& e) { return e.low < line.high; });
      for (std::uint32_t next = first; next <= count_ && edges_[next].low == line.high; ++next) {
        DrawnEdge& other = edges_[next];
        if (other.look == 0 || orientation(line.low, line.high, other.high) != 0) continue;
        line.high = other.high;
        other.look = 0;
        grown = true;
        break;
      }
    }
  }
}

Status LineDrawing::solve() {
  sort_points();
  cut_at_corners();
  if (asked_ != 0) {
    count_ = 0;
    return {Code::pool_exhausted, "lines", "polygon", asked_ - 1u, 0, edges_.capacity() + 1u, edges_.capacity()};
  }
  sort_edges();
  keep_borders();
  join();
  return {};
}

}  // namespace spanline::area
