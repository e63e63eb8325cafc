// One pass over the edges of a line, from left to right: where it stands, and its common part.
#pragma once

#include <utility>

#include "core/vsg/active_edge.hpp"

namespace spanline {

// Spans come from left to right, so a painter may write this many pixels too far, but not past the line's end.
inline constexpr std::int32_t kOvershoot = 8;

// Puts an edge in its place among those in [begin, end) that come before `end`; the last of them is to come after it.
void insert_back(const ActiveEdge* begin, ActiveEdge* end, const ActiveEdge& edge) asm("spanline_insert_back");

// The edges alive and those that begin on the line are two runs in order of x, merged on the way: edges are taken from
// one as long as the other's next does not come before them. Assembly knows where each member stands.
struct LineWalk {
  const ActiveEdge* edge;   // the next of the run at hand
  ActiveEdge* out;          // behind the last of the next line's
  std::int32_t limit;       // where edge->x is beyond this, the next edge is the other run's, or at the right end
  std::int32_t left;        // the column come to
  CoverKey key;             // of the pixels from there on
  std::int32_t furthest;    // x of out[-1]
  std::uint8_t* pixels;     // of the line, on a word boundary
  const void* faces;        // what the painter knows of each, by its id
  const ActiveEdge* other;  // the next of the other run
  std::int32_t side;        // up to this x a span that ends there may overshoot
  ActiveEdge* begin;        // the first of the next line's
  const void* painter;      // what else is painted with
  ActiveEdge* now;          // the line's edges: those alive and a sentinel, those that begin and theirs
  ActiveEdge* alive_end;    // that sentinel

  // To the first edge of the line.
  void begin_line() {
    edge = now;
    out = begin;
    other = alive_end + 1;
    limit = limit_by(other->x);
    left = 0;
    key = 0;
    furthest = INT32_MIN;
  }
  // Whether nothing lies right of the column come to.
  bool is_through() const { return key == 0 && edge->x == ActiveEdge::kNever && other->x == ActiveEdge::kNever; }
  // The next line's edges become the line's.
  void end_line() {
    std::swap(now, begin);
    end_alive(out);
  }
  // Those alive end here, and none begins.
  void end_alive(ActiveEdge* end) {
    alive_end = end;
    end[0].x = end[1].x = ActiveEdge::kNever;
  }

  // What lies beyond `side` is at the right end.
  static constexpr std::int32_t side_of(std::int32_t width) {
    return (width - kOvershoot + 1) * (1 << ActiveEdge::kFraction) - 1;
  }
  // The limit of one run, where the other's next edge has this x.
  std::int32_t limit_by(std::int32_t x) const { return x < side ? x : side; }
  const ActiveEdge* next() const { return edge->x > limit ? other : edge; }
  // The next of those alive, and of those that begin, which stand behind them.
  const ActiveEdge* alive() const { return edge < other ? edge : other; }
  const ActiveEdge* begun() const { return edge < other ? other : edge; }
  // Puts *out, which its left neighbours may be beyond, in its place.
  [[gnu::noinline]] void put_out() {
    if (out->x < furthest) [[unlikely]] {
      insert_back(begin, out, ActiveEdge{*out});
    } else {
      furthest = out->x;
    }
    ++out;
  }
};

enum class WalkStop : std::uint32_t {
  side,   // the next edge lies at the right end, or there is none
  front,  // before the next edge lies a span of several faces
  tall,   // *out is an edge that has been taken and ended, or has to begin again
  look,   // before the next edge lies a span of one face that the painter does not know
  end,    // in place of side where the walk is through, if the walk has filled the rest of the line and ended it
};
constexpr bool goes_on(WalkStop stop) { return stop != WalkStop::side && stop != WalkStop::end; }

// Walks on until it has to stop. `shown` is the face that the span shows at which the walk has stopped; 0: it has not
// stopped at one, or the column has been brought to its end. paint(left, right, FaceId) takes spans of one face or none
// (0); false where it has to stop before this one.
template <typename Paint>
WalkStop walk_on(LineWalk& walk, FaceId shown, const Paint& paint) {
  // Known to nobody else, so that pixels cannot overwrite them.
  const ActiveEdge* edge = walk.edge;
  ActiveEdge* out = walk.out;
  std::int32_t limit = walk.limit, left = walk.left, furthest = walk.furthest;
  CoverKey key = walk.key;
  WalkStop stop;
  for (;;) {
    std::int32_t x = edge->x;
    if (x > limit) [[unlikely]] {
      stop = WalkStop::side;
      if (limit == walk.side) break;
      limit = walk.limit_by(x);
      std::swap(edge, walk.other);
      continue;
    }
    const std::int32_t column = x >> ActiveEdge::kFraction;
    if (column > left) {
      if (shown == 0) {
        stop = WalkStop::front;
        if (key >= kTwoFaces) [[unlikely]]
          break;
        shown = only_face(key);
      }
      stop = WalkStop::look;
      if (!paint(left, column, shown)) [[unlikely]]
        break;
      shown = 0;
      left = column;
    }
    const CoverKey toggle = edge->toggle;
    const std::uint32_t rest = edge->rest;
    const std::int32_t dx = edge->dx;
    ++edge;
    key += toggle;
    out->dx = dx;
    out->toggle = toggle;
    if (rest < ActiveEdge::kOneLine) [[unlikely]] {
      if ((rest & ActiveEdge::kTall) == 0) continue;
      out->rest = rest;
      stop = WalkStop::tall;
      break;
    }
    x += dx;
    out->x = x;
    out->rest = rest - ActiveEdge::kOneLine;
    if (x < furthest) [[unlikely]] {
      insert_back(walk.begin, out, ActiveEdge{*out});
    } else {
      furthest = x;
    }
    ++out;
  }
  walk.edge = edge;
  walk.out = out;
  walk.limit = limit;
  walk.left = left;
  walk.key = key;
  walk.furthest = furthest;
  return stop;
}

}  // namespace spanline
