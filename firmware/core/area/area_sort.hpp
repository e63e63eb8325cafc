// Hidden surface removal by polygon area sorting (seed 2): polygons in, their visible pieces out. Pieces never overlap,
// name the polygon they are of, lie in its plane, and cover every place that some polygon covers.
//
// The four steps of the seed: a rough depth sort by the nearest point; the x-y sort of all polygons to the area of the
// front one, which is always its original copy; removal of what lies behind it; and recursion with whatever lies in
// front of it. The stack of clip polygons tells a cyclic overlap from an error of the first sort.
//
// Before them polygons that pierce one another are split along their line (pierce.hpp), and all borders are led
// together through the grid points where they cross (arrangement.hpp). From then on every clip meets in grid points
// alone: nothing is rounded again, pieces and originals fit without a seam, and no error adds up. A border lies within
// half a unit in x and y of where it should; one that was cut by a line (a window's side, or where polygons pierce)
// within a unit.
//
// Translucent polygons are not drawn as pieces, unless that is asked for: whatever lies behind one names it among its
// films, and so does the backdrop where nothing else lies there.
#pragma once

#include "core/area/borders.hpp"
#include "core/area/clipper.hpp"
#include "core/area/plane.hpp"
#include "core/area/widest_triangle.hpp"

namespace spanline::area {

inline constexpr std::uint16_t kBackdrop = 0xffff;  // the source of pieces with films and nothing opaque behind them

inline constexpr std::uint16_t kBackdropGroup = 0xffff;

enum class Opacity : std::uint8_t { opaque, translucent };

// What becomes of translucent polygons: they are named by what lies behind them; or they are pieces, too, which what
// lies behind them overlaps, and name what translucent polygons lie before them; or they are such pieces, and nothing
// names them, which takes no films.
enum class Panes : std::uint8_t { named, shown, unnamed };

// A polygon under its name (its index), whose border is the original copy that others are clipped to.
struct NamedPolygon {
  Plane plane;
  std::int64_t nearest;  // the plane's largest value on the border
  Border border;
  Box bounds;
  std::uint16_t source;
  Opacity opacity;
  bool on_stack;  // is a clip polygon whose area is not finished
  // Surface detail, the faces of a consolidated solid too, is no part of the sort; it is cut out of the visible pieces
  // of the polygon that it lies on, which has the same group (0: none).
  std::uint16_t group = 0;
  bool detail = false;
  bool silhouette = false;  // of a solid: all that is seen of it is detail
  std::uint16_t first_detail = 0, details = 0;
};

// A part of a polygon.
struct Piece {
  Border border;
  Box bounds;
  std::uint16_t name;   // the polygon
  std::uint16_t films;  // translucent polygons in front of it
  std::uint16_t next;
};

struct Film {
  std::uint16_t name;
  std::uint16_t next;
};

struct PieceList {
  std::uint16_t first = 0, last = 0;
};

// One level of the recursion: a clip polygon, what is left of the list inside of it, and what it cut off.
struct SortFrame {
  std::uint16_t clip;
  PieceList inside, outside;
};

struct SortPools {
  PoolRef<NamedPolygon> polygons;
  PoolRef<BorderEdge> borders;  // of originals and pieces
  PoolRef<Piece> pieces;
  PoolRef<Film> films;
  PoolRef<SortFrame> frames;
  Pools clipper;  // segments and nodes must hold all borders of one window and their intersections
};

// The owner.
template <std::uint16_t kPolygons, std::uint16_t kBorders, std::uint16_t kPieces, std::uint16_t kFilms>
struct SortStorage {
  Pool<NamedPolygon, kPolygons> polygons;
  Pool<BorderEdge, kBorders> borders;
  Pool<Piece, kPieces> pieces;
  Pool<Film, kFilms> films;
  Pool<SortFrame, kPolygons + 1> frames;
  PoolStorage<kBorders, kBorders, kBorders, kPieces> clipper;
  SortPools refs() { return {polygons.ref(), borders.ref(), pieces.ref(), films.ref(), frames.ref(), clipper.refs()}; }
};

// What the sort did.
struct SortCounts {
  std::uint32_t clips = 0;        // runs of the clipper on two polygons
  std::uint32_t pairs = 0;        // lateral comparisons: pieces held against a clip polygon
  std::uint32_t depth_tests = 0;  // pieces inside an area compared with its clip polygon
  std::uint32_t pierced = 0;      // pairs of polygons that pierce each other
  std::uint32_t recursions = 0;   // errors of the first sort
  std::uint32_t cyclic = 0;       // polygons in front of the clip polygon whose name was on the stack
  std::uint32_t dropped = 0;      // polygons without area
  std::uint32_t details = 0;      // runs of the clipper that cut detail out of visible pieces
  std::uint16_t polygons = 0, borders = 0, pieces = 0, films = 0, frames = 0;  // most blocks in use at once

  // Another sort's: what was done adds up, of blocks the larger number stays.
  void add(const SortCounts& other);
};

// What lies from `low` on and before `high`, depths.
struct Slab {
  std::int32_t low = 0, high = kMaxDepth + 1;
};

class AreaSort {
 public:
  AreaSort() = default;
  explicit AreaSort(const SortPools& pools, Panes panes = Panes::named);

  // Begins anew. What lies outside of the window and of the slab is cut away.
  void clear(const Box& window = Box::all(), const Slab& slab = {});

  // A plane polygon: concave, with holes, even-odd; contours in any direction and order. Its plane is that of the three
  // of its corners that span (nearly) the largest triangle. `source` (below kBackdrop) is its name outside, and decides
  // where depths are equal: the lower one is in front. Coordinates within ±kMaxCoordinate, depth within 0 … kMaxDepth,
  // larger is nearer. The order of the polygons changes nothing in the result.
  void begin_polygon(std::uint16_t source, Opacity opacity = Opacity::opaque);
  // The same in a plane that is known; the depths of its vertices are not looked at.
  void begin_polygon(std::uint16_t source, const Plane& plane, Opacity opacity = Opacity::opaque);
  void begin_contour() { corners_ = 0; }
  void vertex(std::int32_t x, std::int32_t y, std::int32_t depth);
  void end_contour();
  void end_polygon();

  // Surface detail of the polygon put in last: contours and end_polygon() follow. It is seen where that polygon is and
  // it covers; of several the highest source lies on top. It takes that polygon's plane; the depths of its vertices are
  // not looked at. Not for polygons within a group.
  void begin_detail(std::uint16_t source);

  // What is put in between is what is seen of one convex solid: opaque polygons that do not overlap. One silhouette
  // polygon stands for all of them, and they are cut out of its pieces when those are shown (the seed's consolidation).
  // Where something pierces one of them they are sorted one by one.
  void begin_group();
  void end_group();

  // Polygons put in between are a backdrop: they lie behind everything else, do not overlap, and are shown where
  // nothing else is. Their planes do not matter to the sort. At most once, and not with translucent polygons.
  void begin_backdrop();
  void end_backdrop();

  // Sorts. Not ok: bad_argument (field "x", "y" or "depth") or pool_exhausted (where: the pool; index: the source of
  // the polygon that asked for more, or of one of those that need the background where that did; limit: its capacity),
  // and then there are no pieces.
  Status solve();

  const Status& status() const { return status_; }
  const SortCounts& counts() const { return counts_; }
  Panes panes() const { return panes_; }

  // Hands the visible pieces to `sink`, ordered by nothing in particular but always the same: begin_piece(source,
  // plane); film(source) from front to back; main contour, then its holes: begin_contour(), vertex(GridPoint)…,
  // end_contour(); end_piece(). Contours run with the inside to the right (y up).
  template <typename Sink>
  void read(Sink& sink) const;

 private:
  void refuse(const char* field, std::int32_t value, std::int32_t limit);
  bool exhausted(const char* pool, std::uint16_t capacity, std::uint16_t source);
  bool borders_fit(std::uint16_t source);

  std::uint16_t add_polygon(std::uint16_t source, const Plane& plane, Opacity opacity, const Border& border);
  std::uint16_t add_backdrop();
  bool cut_to_slab(const Plane& plane);
  bool cut_at(const Plane& plane, std::int32_t depth, bool keep_nearer);
  void sort_by_source();
  bool can_pierce(const NamedPolygon& polygon) const;
  bool of_solid(const NamedPolygon& polygon) const;
  bool pierce_all();
  bool pierce(std::uint16_t one, std::uint16_t other);
  bool split(std::uint16_t name, const Line& line);
  void share_meetings(std::uint16_t name, const Line& line);
  void dissolve(std::uint16_t group);
  bool settle();
  std::uint16_t owner_of(const Segment& segment) const;
  void order_by_depth();
  void find_details();
  bool make_pieces();
  bool resolve(std::uint16_t name);

  bool run();
  std::uint16_t offender() const;
  bool push(std::uint16_t clip);
  enum class Place : std::uint8_t { apart, within, unknown };
  Place place_of(const Piece& piece, const NamedPolygon& clip) const;
  bool divide(std::uint16_t piece);
  bool keep_inside(std::uint16_t piece);
  bool show_and_pop();
  bool nearer(const Piece& piece, std::uint16_t clip) const;
  std::int64_t value(const NamedPolygon& polygon, GridPoint p) const;
  bool show(std::uint16_t piece);
  bool show_detail(PieceList& rest, const NamedPolygon& host);
  bool cut_detail(std::uint16_t piece, std::uint16_t detail, PieceList& rest);
  bool sort_films(Piece& piece);
  bool take_pieces(List list, const Piece& like, PieceList& to);
  void append(PieceList& list, std::uint16_t piece);
  void release(std::uint16_t piece);
  NamedPolygon& polygon_of(const Piece& piece) const { return pools_.polygons[piece.name]; }

  SortPools pools_;
  Clipper clipper_;
  Borders borders_;
  FreeList<Piece, &Piece::next> pieces_;
  FreeList<Film, &Film::next> films_;
  std::uint16_t polygons_ = 0, depth_ = 0;
  PieceList visible_;
  Box window_;
  Slab slab_;
  Status status_;
  SortCounts counts_;
  Panes panes_ = Panes::named;
  bool translucent_ = false;              // some polygon is
  std::uint16_t host_ = 0;                // the polygon that detail would lie on, 0: it is not seen
  bool detail_ = false;                   // what is being put in
  std::uint16_t group_ = 0, groups_ = 0;  // the group being put in, and how many there have been
  Border silhouette_;                     // of that group: edges that two members share cancel

  // The polygon being put in.
  std::uint16_t source_ = 0;
  Opacity opacity_ = Opacity::opaque;
  Border border_;
  GridPoint start_, last_;
  std::uint32_t corners_ = 0;  // of the contour
  WidestTriangle widest_;
  std::int32_t widest_depth_[3];
  Plane given_plane_;
  bool plane_given_ = false;
};

template <typename Sink>
void AreaSort::read(Sink& sink) const {
  for (std::uint16_t i = visible_.first; i != 0; i = pools_.pieces[i].next) {
    const Piece& piece = pools_.pieces[i];
    sink.begin_piece(polygon_of(piece).source, polygon_of(piece).plane);
    for (std::uint16_t f = piece.films; f != 0; f = pools_.films[f].next) {
      sink.film(pools_.polygons[pools_.films[f].name].source);
    }
    GridPoint start;
    bool open = false;
    borders_.each(piece.border, [&](const BorderEdge& edge) {
      if (!open) {
        sink.begin_contour();
        start = edge.from;
      }
      sink.vertex(edge.from);
      open = !(edge.to == start);
      if (!open) sink.end_contour();
    });
    sink.end_piece();
  }
}

}  // namespace spanline::area
