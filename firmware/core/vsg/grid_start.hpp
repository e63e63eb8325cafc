// The edges that begin on a line where faces lie in grids: each from its upper end to its neighbours in the grid.
#pragma once

#include <cstddef>
#include <utility>

#include "core/vsg/active_edge.hpp"
#include "core/vsg/line_walk.hpp"

namespace spanline {

// What cell v of a grid covers, whose first corner is vertex v: its faces are 2 v, and 2 v + 1 where the triangle below
// is a face of its own. Bits of `parts` say whether the upper, the lower triangle is drawn and whether they are apart.
struct CellCovers {
  static constexpr std::uint32_t kUpper = 1, kLower = 2, kApart = 4;

  CoverKey upper = 0, lower = 0;

  CellCovers() = default;
  CellCovers(std::uint32_t vertex, std::uint32_t parts) {
    const CoverKey cover = cover_of(vertex);
    upper = only_if(parts & kUpper, cover);
    lower = only_if((parts & kLower) / kLower, cover + parts / kApart);
  }

  // The upper one alone; of a cell that is not apart, which covers as a whole or not at all.
  static CoverKey upper_of(std::uint32_t vertex, std::uint32_t parts) {
    return only_if(parts & kUpper, cover_of(vertex));
  }

 private:
  static CoverKey cover_of(std::uint32_t vertex) { return (CoverKey{1} << kCoverCount) + 2 * vertex; }
  static CoverKey only_if(std::uint32_t bit, CoverKey cover) { return (0u - bit) & cover; }
};

// How large a cell's triangles are on the screen, doubled, and negative where they turn their fronts to the viewer.
struct CellAreas {
  std::int32_t upper, lower;

  // Of the cell whose first corner that is.
  template <typename Vertex>
  explicit CellAreas(const Vertex* first) {
    const Vertex* const below = first + first->stride;
    const PackedXY a(first->at), c(below[1].at);
    upper = doubled_area_near(a, PackedXY(first[1].at), c);
    lower = doubled_area_near(a, c, PackedXY(below->at));
  }
  std::int32_t both() const { return upper + lower; }
  // Whether a face shows its back: FaceId 2 v or 2 v + 1 of cell v, whose triangles are apart or not.
  bool is_back(std::uint32_t face, bool apart) const { return (!apart ? both() : face % 2u != 0 ? lower : upper) > 0; }
};

// Puts *end in its place among the edges before it, which are in order of x, behind a sentinel whose x is less. True
// where it has become one with another: the two halves of a joint of grids are one edge, whose faces are of two grids.
bool take_in(ActiveEdge* end) asm("spanline_take_in");

// Vertices of a list, as many as fit, from left to right: x above each one's number, and a word of 0 behind the last.
// What the next ones begin stands among what these have begun, in whatever order.
class GridKeys {
 public:
  // Those from `vertex` on, through `next`.
  template <typename Vertex>
  GridKeys(const Vertex* vertices, std::uint32_t vertex) {
    std::int32_t* end = keys_;
    *end++ = INT32_MIN;  // less than any
    do {
      const Vertex& at = vertices[vertex];
      const auto key = static_cast<std::int32_t>(PackedXY(at.at).word << 16 | vertex);
      std::int32_t* to = end++;
      for (; to[-1] > key; --to) *to = to[-1];
      *to = key;
      vertex = at.next;
    } while (vertex != 0 && end != keys_ + 1 + kMost);
    *end = 0;
    rest_ = vertex;
  }
  const std::int32_t* first() const { return keys_ + 1; }
  static std::uint32_t vertex(std::int32_t key) { return static_cast<std::uint16_t>(key); }
  // The first one that had no room, through `next`; 0: all had.
  std::uint32_t rest() const { return rest_; }

 private:
  static constexpr int kMost = 62;
  std::int32_t keys_[1 + kMost + 1];
  std::uint32_t rest_;
};

// Where it stands among the vertices of GridKeys. Assembly knows where each member stands.
struct GridList {
  const void* vertices;
  const std::int32_t* key;  // of the next one
  std::int32_t line;
  ActiveEdge* out;      // behind the last edge that begins; out[-1].x is that of a sentinel, INT32_MIN, to start with
  std::uintptr_t last;  // beyond which out has no room for all edges of a vertex, as a number
};

#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
// GridStart::start_plain() in assembly up to the first vertex that is a corner of both triangles of a cell where they
// are apart, or for whose edges there may be no room. True where it came to the end.
bool start_cells(GridList& list) asm("spanline_start_cells");
#endif

// Starts the edges of vertices that begin on one line. kBothSides: cells may show their backs; else all that are drawn
// show their fronts.
template <typename Vertex, bool kBothSides = false>
class GridStart {
 public:
  GridStart(const Vertex* vertices, std::int32_t line) : vertices_(vertices), line_(line) {}

  // Those of a list of vertices through `next`, which is not empty, the first one to `begin`, before which a sentinel's
  // x is INT32_MIN, none to `last`. Returns their end, or null where there is no room for all.
  ActiveEdge* start(std::uint32_t vertex, ActiveEdge* begin, const ActiveEdge* last) const {
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
    if constexpr (!kBothSides) {
      return start_keys(vertex, begin, [this, last](const std::int32_t* key, ActiveEdge* out) {
        return start_quickly(key, out, last);
      });
    }
#endif
    return start_plain(vertex, begin, last);
  }
  // The same for any core.
  ActiveEdge* start_plain(std::uint32_t vertex, ActiveEdge* begin, const ActiveEdge* last) const {
    const GridStart here = *this;  // what is written is none of it
    return start_keys(vertex, begin, [here, last](const std::int32_t* key, ActiveEdge* out) {
      for (; *key != 0 && out != nullptr; ++key) {
        const std::uint32_t at = GridKeys::vertex(*key);
        ActiveEdge* const end =
            static_cast<std::size_t>(last - out) >= kMost ? here.put(at, out) : put_in_little_room(here, at, out, last);
        out = here.take_all_in(at, out, end);
      }
      return out;
    });
  }

 private:
  static constexpr std::size_t kMost = kBothSides ? 12 : 6;  // edges of a vertex

  // start_run(key, out) for as many of the list's vertices at once as GridKeys hold.
  template <typename StartRun>
  ActiveEdge* start_keys(std::uint32_t vertex, ActiveEdge* out, const StartRun& start_run) const {
    do {
      const GridKeys keys(vertices_, vertex);
      out = start_run(keys.first(), out);
      vertex = keys.rest();
    } while (vertex != 0 && out != nullptr);
    return out;
  }
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB == 2
  ActiveEdge* start_quickly(const std::int32_t* key, ActiveEdge* out, const ActiveEdge* last) const {
    static_assert(sizeof(Vertex) == 12 && offsetof(Vertex, at) == 4, "assembly knows it");
    GridList list{vertices_, key, line_, out, reinterpret_cast<std::uintptr_t>(last) - kMost * sizeof(ActiveEdge)};
    while (!start_cells(list)) {
      const std::uint32_t at = GridKeys::vertex(*list.key++);
      ActiveEdge* const end = reinterpret_cast<std::uintptr_t>(list.out) <= list.last
                                  ? put_any(*this, at, list.out)
                                  : put_in_little_room(*this, at, list.out, last);
      if (end == nullptr) return nullptr;
      list.out = take_all_in(at, list.out, end);
    }
    return list.out;
  }
#endif
  // Runs the vertex's edges, which have been put to `out`, and puts them in their places. Returns their end.
  [[gnu::always_inline]] ActiveEdge* take_all_in(std::uint32_t vertex, ActiveEdge* out, ActiveEdge* end) const {
    if (end == nullptr) [[unlikely]]
      return nullptr;
    const FromVertex from(PackedXY(vertices_[vertex].at), line_);
    while (out != end) {
      from.run(*out, PackedXY(static_cast<std::uint32_t>(out->x)), out->rest);
      // They come nearly in order.
      if (out->x > out[-1].x || !take_in(out)) [[likely]] {
        ++out;
        continue;
      }
      --end;
      for (ActiveEdge* to = out; to != end; ++to) *to = to[1];
    }
    return out;
  }
  // Puts the vertex's edges to `out`, as FromVertex::run_far() takes them. Returns their end.
  [[gnu::always_inline]] ActiveEdge* put(std::uint32_t vertex, ActiveEdge* out) const {
    const Vertex* const at = &vertices_[vertex];
    const std::uint32_t stride = at->stride;
    const Vertex *const up = at - stride, *const down = at + stride;
    // The cells around the vertex; beyond the grid's rim they have no parts. Two of them have it in both their
    // triangles, of the other two only one is beside its edges.
    const CoverKey below_right = CellCovers::upper_of(vertex, at->parts);
    const CoverKey below_left = CellCovers::upper_of(vertex - 1, at[-1].parts);
    CoverKey above_right = 0, above_left = 0;
    std::uint32_t parts = at->parts;
    bool rises = kBothSides;  // the grid's row above lies below the line on the screen, as far as is asked
    if (at->first_row == 0) {
      parts |= up[-1].parts;
      above_right = CellCovers(vertex - stride, up->parts).lower;
      above_left = CellCovers::upper_of(vertex - stride - 1, up[-1].parts);
      if (!kBothSides) rises = PackedXY(up->at).y() > line_ * kSubpixels + kSubpixels / 2;
    }
    if ((parts & CellCovers::kApart) != 0) [[unlikely]]
      return put_any(*this, vertex, out);
    // Counter-clockwise, so that they mostly come from left to right.
    if (rises) {
      put_edge(at - 1, above_left, below_left, out);
      put_edge(up, above_right, above_left, out);
    }
    put_edge(at + 1, below_right, above_right, out);
    put_edge(down, below_left, below_right, out);
    if (!rises) put_edge(at - 1, above_left, below_left, out);
    return out;
  }
  // The same whatever its cells are.
  [[gnu::noinline]] static ActiveEdge* put_any(GridStart here, std::uint32_t vertex, ActiveEdge* out) {
    const Vertex* const at = &here.vertices_[vertex];
    const std::uint32_t stride = at->stride;
    const Vertex *const up = at - stride, *const down = at + stride;
    const CellCovers below_right(vertex, at->parts), below_left(vertex - 1, at[-1].parts);
    CellCovers above_right, above_left;
    if (at->first_row == 0) {
      above_right = {vertex - stride, up->parts};
      above_left = {vertex - stride - 1, up[-1].parts};
      here.put_edge(up, above_right.lower, above_left.upper, out);
      here.put_edge(up - 1, above_left.upper, above_left.lower, out);
    }
    here.put_edge(at - 1, above_left.lower, below_left.upper, out);
    here.put_edge(at + 1, below_right.upper, above_right.lower, out);
    here.put_edge(down, below_left.upper, below_right.lower, out);
    here.put_edge(down + 1, below_right.lower, below_right.upper, out);
    return out;
  }
  // Puts the edge to there, if it runs down: half of the edges run up. The face counter-clockwise of an edge lies on
  // its right, if it shows its front. Where both sides are the same, there may be no neighbour.
  [[gnu::always_inline]] void put_edge(const Vertex* to, CoverKey begins, CoverKey ends, ActiveEdge*& out) const {
    if (begins == ends) return;
    const PackedXY bottom(to->at);
    if (bottom.y() <= line_ * kSubpixels + kSubpixels / 2) return;
    out = kBothSides ? put_sides(*this, out, bottom, begins, ends) : put_one(out, bottom, begins, ends);
  }
  static ActiveEdge* put_one(ActiveEdge* out, PackedXY bottom, CoverKey begins, CoverKey ends) {
    out->x = static_cast<std::int32_t>(bottom.word);
    out->toggle = begins - ends;
    out->rest = static_cast<FaceId>(ends);
    return out + 1;
  }
  // The same of faces that may show their backs.
  [[gnu::noinline]] static ActiveEdge* put_sides(GridStart here, ActiveEdge* out, PackedXY bottom, CoverKey begins,
                                                 CoverKey ends) {
    const bool swap_begins = begins != 0 && here.is_back(begins), swap_ends = ends != 0 && here.is_back(ends);
    if (begins != 0 && ends != 0 && swap_begins != swap_ends) {  // a fold: both lie on the same side
      out = swap_begins ? put_one(out, bottom, 0, begins) : put_one(out, bottom, begins, 0);
      return swap_ends ? put_one(out, bottom, ends, 0) : put_one(out, bottom, 0, ends);
    }
    if (swap_begins || swap_ends) std::swap(begins, ends);
    return put_one(out, bottom, begins, ends);
  }
  bool is_back(CoverKey cover) const {
    const FaceId face = only_face(cover);
    const Vertex* const cell = &vertices_[face / 2u];
    return CellAreas(cell).is_back(face, (cell->parts & CellCovers::kApart) != 0);
  }
  // The same by way of elsewhere; null where there is no room for those that begin.
  [[gnu::cold, gnu::noinline]] static ActiveEdge* put_in_little_room(GridStart here, std::uint32_t vertex,
                                                                     ActiveEdge* out, const ActiveEdge* last) {
    ActiveEdge edges[kMost];
    const ActiveEdge* const end = put_any(here, vertex, edges);
    if (end - edges > last - out) return nullptr;
    for (const ActiveEdge* edge = edges; edge != end; ++edge) *out++ = *edge;
    return out;
  }

  const Vertex* vertices_;
  std::int32_t line_;
};

}  // namespace spanline
