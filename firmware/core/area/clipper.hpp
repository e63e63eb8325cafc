// The polygon clipper of seed 2: concave polygons with holes against concave polygons with holes, both lists at once.
//
// How it realises the seed's clipper. The borders of both polygons are cut at all their intersections, on each other
// and on themselves, and every piece is stored once with both directions (arrangement.hpp): a piece of the clip
// polygon's border inside the subject bounds a contour of the inside list in one direction and one of the outside list
// in the other — the seed's two copies, one reversed, and the link between them is partner(). Intersection vertices are
// tagged. What each polygon covers left and right of a piece follows from the even-odd rule, counted on the pieces;
// shared, opposed and identical borders are one piece that both own, and a piece that a polygon passes twice does not
// border it. So every degeneracy is the same case as a plain intersection, and self-crossing input is resolved by the
// same counting. Contours are then followed with a turn to the right at every intersection, and holes attached at the
// end.
//
// Contours run with their inside to the right (seed 2: main contours clockwise, holes counter-clockwise, y up). A
// contour touches itself nowhere and others in single points only. Order and direction of the input change nothing in
// the output, and the output put in again comes out unchanged.
//
// Rounding: intersections off the grid go to the nearest grid point, and every border moves by at most half a unit in x
// and in y; the lists stay an exact partition of the moved subject. Its area differs from the subject's by less than
// √½ unit × length of its moved borders, and not at all where counts().moved is 0.
#pragma once

#include "core/area/tracer.hpp"
#include "core/base/status.hpp"

namespace spanline::area {

enum class List : std::uint8_t { inside, outside };

// What the clipper met.
struct ClipCounts {
  std::uint32_t dropped_contours = 0;  // input contours without area: fewer than three points, or all on one line
  std::uint32_t merged_points = 0;     // input points equal to their forerunner
  std::uint16_t rounded = 0;           // intersections off the grid
  std::uint16_t moved = 0;             // input edges led through rounded points
  std::uint16_t segments = 0, nodes = 0, edges = 0, contours = 0;  // blocks in use
};

class Clipper {
 public:
  Clipper() = default;
  // Pools above the reach of a 16-bit index are used in part.
  explicit Clipper(Pools pools);

  // Begins anew. The names go into messages about the polygons, `index` of a Status.
  void clear(std::uint32_t subject_name = 0, std::uint32_t clip_name = 0);

  // One contour of a polygon; direction, order and nesting are free (even-odd). Coordinates within ±kMaxCoordinate.
  // The first thing that is wrong stays the status.
  void begin_contour(Role role);
  void vertex(std::int32_t x, std::int32_t y);
  void end_contour();

  // One edge of a polygon whose edges close somehow; ends that coincide are no edge.
  void edge(Role role, GridPoint from, GridPoint to);

  // Solve the polygons put in; then the lists hold the result, or nothing where the status is not ok: bad_argument
  // (field "x" or "y", needed: the value, limit) or pool_exhausted (where: segments, nodes, edges or contours; field:
  // "subject" or "clip", the polygon that asked for more; limit: the pool's capacity). Each is called once after
  // clear().
  Status clip() { return solve(kBoth, kSubjectOnly); }  // inside: subject and clip; outside: subject alone
  Status unite() { return solve(kBoth | kSubjectOnly | kClipOnly, 0); }  // inside: either; with one polygon: resolve it
  Status differ() { return solve(kSubjectOnly, kClipOnly); }  // inside: subject - clip; outside: clip - subject

  const Status& status() const { return status_; }
  const Pools& pools() const { return pools_; }
  const ClipCounts& counts() const { return counts_; }

  // The contours of a list, for reading: first_main(list), next(), holes by first_hole(); 0 ends each chain.
  std::uint16_t first_main(List list) const { return solved_ ? tracer_.first(static_cast<std::uint8_t>(list)) : 0; }
  std::uint16_t first_hole(std::uint16_t main) const { return pools_.contours[main].relation; }
  std::uint16_t next_contour(std::uint16_t contour) const { return pools_.contours[contour].next; }

  // Around a contour: from its first half-edge by next_edge() until that comes again.
  HalfEdge first_edge(std::uint16_t contour) const { return pools_.contours[contour].first; }
  HalfEdge next_edge(HalfEdge h) const { return tracer_.next(h); }
  GridPoint origin(HalfEdge h) const { return tracer_.origin(h); }
  bool at_intersection(HalfEdge h) const { return tracer_.at_intersection(h); }
  // Whose border the edge is: bit 0 the subject's, bit 1 the clip polygon's.
  Cover borders(HalfEdge h) const { return pools_.edges[h >> 1].borders; }
  // The same edge in the other list's contour, in reverse; 0 where it has none.
  HalfEdge linked(HalfEdge h) const { return tracer_.list_bounded_by(partner(h)) != 0 ? partner(h) : HalfEdge{0}; }

  // Hands a list to `sink`: begin_polygon(), then main contour and holes, each begin_contour(), vertex(x, y)…,
  // end_contour(); end_polygon().
  template <typename Sink>
  void read(List list, Sink& sink) const {
    for (std::uint16_t main = first_main(list); main != 0; main = next_contour(main)) {
      sink.begin_polygon();
      read_contour(main, sink);
      for (std::uint16_t hole = first_hole(main); hole != 0; hole = next_contour(hole)) read_contour(hole, sink);
      sink.end_polygon();
    }
  }

 private:
  static constexpr CoverSet kSubjectOnly = 1 << 1, kClipOnly = 1 << 2, kBoth = 1 << 3;

  template <typename Sink>
  void read_contour(std::uint16_t contour, Sink& sink) const {
    sink.begin_contour();
    HalfEdge h = first_edge(contour);
    do {
      sink.vertex(origin(h).x, origin(h).y);
      h = next_edge(h);
    } while (h != first_edge(contour));
    sink.end_contour();
  }

  Status solve(CoverSet inside, CoverSet outside);
  void add_segment(GridPoint from, GridPoint to);
  void refuse(const char* axis, std::int32_t value);
  void exhausted(const char* pool, Role role, std::uint16_t capacity);

  Pools pools_;
  Arrangement arrangement_;
  Tracer tracer_;
  Status status_;
  ClipCounts counts_;
  std::uint32_t names_[2] = {0, 0};
  bool solved_ = false;

  // The contour being put in. Points that repeat their forerunner, and a last point equal to the first, are merged.
  Role role_ = Role::subject;
  GridPoint start_, last_, apart_;    // first and last point; the first that differs from start_
  std::uint16_t before_contour_ = 0;  // segments before it, to go back to where it has no area
  std::uint32_t points_ = 0;          // distinct from their forerunner
  bool has_area_ = false;             // three points not on one line
};

}  // namespace spanline::area
