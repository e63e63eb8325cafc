// The segment eliminator (III.B): packs the segment lists of the polygons that changed, frees blocks, and files the
// segments whose left edge is new.
#pragma once

#include "core/vsg/edge_table.hpp"
#include "core/vsg/polygons.hpp"

namespace spanline {

// XSort: XSortList or XSortBuckets.
template <bool kCount, typename XSort>
class SegmentEliminator {
 public:
  SegmentEliminator() = default;
  SegmentEliminator(SegmentStore<kCount>* store, Polygons* polygons, XSort* x_sort)
      : store_(store), polygons_(polygons), x_sort_(x_sort) {}

  // Before any edge enters on a line: gives back what ended on the line before, so that a line never needs more blocks
  // than it has segments. True where nothing is left of the polygon and its block is given back too. A single block
  // whose edges both ended is kept for those that take their place on this line.
  bool release(std::uint16_t index, const EdgeTable& edges, std::int32_t line) {
    PolygonBlock& polygon = (*polygons_)[index];
    if (polygon.first_segment == 0) return false;
    if ((polygon.flags & PolygonBlock::kFinished) != 0) {  // known from the register: no need to look at the block
      store_->give(polygon.first_segment);
      polygons_->close(index);
      return true;
    }
    const SegmentBlock& first = store_->held(polygon.first_segment);
    const bool ended = first.half[0].empty() && first.half[1].empty();
    if (first.polygon_next != 0 || (ended && !edges.enters(index, line))) {
      trim(polygon, (close_gaps(polygon.first_segment) + 1) / 2);
    }
    const bool over = polygon.first_segment == 0 && polygon.waiting == 0;
    if (over) polygons_->close(index);
    return over;
  }

  // After an edge has entered: where that left the polygon with one whole segment, files it at once, while its block is
  // at hand, and packing is done with. True then.
  bool settle(std::uint16_t index) {
    const std::uint16_t only = (*polygons_)[index].first_segment;
    SegmentBlock& block = store_->held(only);
    if (block.polygon_next != 0 || block.half[0].empty() || block.half[1].empty()) return false;
    if (block.half[1].column < block.half[0].column) return false;
    file(only);
    return true;
  }

  // Packs one polygon's list: halves in order of X without gaps, blocks at the end freed, moved blocks filed anew. The
  // polygon's block is given back where nothing of it is left or to come. False where it has an odd number of edges,
  // which no closed contour has; the last edge is then dropped.
  bool pack(std::uint16_t index) {
    PolygonBlock& polygon = (*polygons_)[index];
    if ((polygon.flags & PolygonBlock::kSettled) != 0) {
      polygon.flags &= static_cast<std::uint8_t>(~PolygonBlock::kSettled);
      return true;
    }
    const unsigned halves = close_gaps(polygon.first_segment);
    sort(polygon.first_segment);
    trim(polygon, halves / 2);
    for (std::uint16_t at = polygon.first_segment; at != 0; at = store_->held(at).polygon_next) file(at);
    if (polygon.first_segment == 0 && polygon.waiting == 0) polygons_->close(index);
    return halves % 2 == 0;
  }

  // Takes a polygon away with all that belongs to it.
  void drop(std::uint16_t index, EdgeTable& edges) {
    PolygonBlock& polygon = (*polygons_)[index];
    if ((polygon.flags & PolygonBlock::kActive) != 0) {
      polygons_->filter_changing([index](std::uint16_t other) { return other != index; });
    }
    trim(polygon, 0);
    if (polygon.waiting != 0) edges.forget(index);
    polygons_->close(index);
  }

 private:
  // Puts a block among those that enter on this line, unless it lies in the X-sort list where it should.
  void file(std::uint16_t index) {
    const std::uint16_t flags = store_->held(index).flags;
    if ((flags & (SegmentBlock::kListed | SegmentBlock::kEntering)) != 0 && (flags & SegmentBlock::kMoved) == 0) return;
    x_sort_->remove(index);
    x_sort_->enter(index);
    store_->store(index);
  }

  struct Cursor {
    std::uint16_t block;
    unsigned side;
  };
  void advance(Cursor& c) {
    if (++c.side == 2) c = {store_->held(c.block).polygon_next, 0};
  }

  // Shifts the halves that are not empty to the front; returns how many there are.
  unsigned close_gaps(std::uint16_t first) {
    unsigned count = 0;
    Cursor to{first, 0};
    for (std::uint16_t at = first; at != 0; at = store_->held(at).polygon_next) {
      store_->fetch(at);
      for (unsigned side = 0; side < 2; ++side) {
        if (store_->held(at).half[side].empty()) continue;
        if (to.block != at || to.side != side) move({at, side}, to);
        advance(to);
        ++count;
      }
    }
    return count;
  }

  void move(Cursor from, Cursor to) {
    store_->put(to.block, to.side, store_->get(from.block, from.side));
    store_->held(from.block).half[from.side].lines = 0;
    store_->store(to.block);
  }

  // Insertion sort; a simple polygon's edges are in order already, those of one that crosses itself change places here.
  void sort(std::uint16_t first) {
    bool again = first != 0;
    while (again) {
      again = false;
      Cursor a{first, 0};
      for (Cursor b{first, 1}; b.block != 0 && !is_empty(b); a = b, advance(b)) {
        const PlacedEdge left = store_->get(a.block, a.side), right = store_->get(b.block, b.side);
        if (!(right < left)) continue;
        store_->put(a.block, a.side, right);
        store_->put(b.block, b.side, left);
        store_->store(a.block);
        store_->store(b.block);
        again = true;
      }
    }
  }
  bool is_empty(Cursor c) const { return store_->held(c.block).half[c.side].empty(); }
  // Frees the blocks after the first `keep`.
  void trim(PolygonBlock& polygon, unsigned keep) {
    std::uint16_t* link = &polygon.first_segment;
    for (; keep != 0; --keep) link = &store_->held(*link).polygon_next;
    std::uint16_t at = *link;
    *link = 0;
    while (at != 0) {
      const std::uint16_t next = store_->held(at).polygon_next;
      x_sort_->remove(at);
      store_->give(at);
      at = next;
    }
  }

  SegmentStore<kCount>* store_ = nullptr;
  Polygons* polygons_ = nullptr;
  XSort* x_sort_ = nullptr;
};

}  // namespace spanline
