// Hidden lines removed (seed 2): the borders between visible pieces, each once, as a plotter draws them. Every edge of
// a piece is put in; where two pieces of one polygon meet, which a window or another polygon has cut, there is no line.
// Pieces of see-through polygons may lie over others.
#pragma once

#include "core/area/predicates.hpp"
#include "core/base/pool.hpp"
#include "core/base/status.hpp"

namespace spanline::area {

// An edge of a visible piece, from its lesser to its greater end.
struct DrawnEdge {
  GridPoint low, high;
  std::uint16_t look;  // whose piece; 0: drawn already, as a part of another line
};

class LineDrawing {
 public:
  LineDrawing() = default;
  // `points` holds as many as `edges`: the corners of all pieces.
  LineDrawing(PoolRef<DrawnEdge> edges, PoolRef<GridPoint> points) : edges_(edges), points_(points) {}

  void clear() { count_ = corners_ = asked_ = 0; }

  // An edge of a closed border; ends that coincide are no edge. Between pieces of one `look` (0 … 65534) no line is.
  void edge(GridPoint from, GridPoint to, std::uint16_t look);

  // Finds the lines. pool_exhausted ("lines"; index: the look of the edge that asked for more; limit: the pool's
  // capacity) where not all edges found room: then there are none.
  Status solve();

  // sink.line(from, to): straight runs are one line each.
  template <typename Sink>
  void read(Sink& sink) const {
    for (std::uint16_t i = 1; i <= count_; ++i) {
      if (edges_[i].look != 0) sink.line(edges_[i].low, edges_[i].high);
    }
  }

 private:
  bool add(const DrawnEdge& edge);
  void sort_edges();
  void sort_points();
  void cut_at_corners();
  void keep_borders();
  void join();

  PoolRef<DrawnEdge> edges_;
  PoolRef<GridPoint> points_;
  std::uint16_t count_ = 0, corners_ = 0;
  std::uint16_t asked_ = 0;  // DrawnEdge::look of the first edge without room
};

}  // namespace spanline::area
