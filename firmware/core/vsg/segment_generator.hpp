// The segment generator (III.A): puts the edges that enter on a line into their polygons' segment lists.
#pragma once

#include "core/vsg/polygons.hpp"

namespace spanline {

template <bool kCount>
class SegmentGenerator {
 public:
  SegmentGenerator() = default;
  SegmentGenerator(SegmentStore<kCount>* store, Polygons* polygons) : store_(store), polygons_(polygons) {}

  // Files the edge by X, ties by slope: it goes to its place in the sequence of halves and pushes the later ones on
  // until an empty half takes up the slack. Whether the place is a left or a right half sorts itself out when the
  // eliminator packs the list. False where a new block is needed and none is left: `edge` is then the one still to be
  // filed, so that the caller may make room and call again.
  bool insert(std::uint16_t polygon, PlacedEdge& edge) {
    std::uint16_t last = 0;
    for (std::uint16_t at = (*polygons_)[polygon].first_segment; at != 0; at = store_->held(at).polygon_next) {
      if (pass(at, edge)) return true;
      last = at;
    }
    const std::uint16_t fresh = store_->take();
    if (fresh == 0) return false;
    SegmentBlock& block = store_->held(fresh);
    block.polygon = polygon;
    block.polygon_next = 0;
    block.flags = SegmentBlock::kMoved;
    block.half[1].lines = 0;
    store_->put(fresh, 0, edge);
    store_->store(fresh);
    if (last == 0) {
      (*polygons_)[polygon].first_segment = fresh;
    } else {
      store_->held(last).polygon_next = fresh;
      store_->store(last);
    }
    return true;
  }

 private:
  // Lets the edge pass a block: true where an empty half took it, else `edge` is what goes on to the next block.
  bool pass(std::uint16_t index, PlacedEdge& edge) {
    const SegmentBlock& block = store_->fetch(index);
    bool changed = false, done = false;
    for (unsigned side = 0; side < 2 && !done; ++side) {
      if (block.half[side].empty()) {
        store_->put(index, side, edge);
        done = changed = true;
        continue;
      }
      const PlacedEdge resident = store_->get(index, side);
      if (edge < resident) {
        store_->put(index, side, edge);
        edge = resident;
        changed = true;
      }
    }
    if (changed) store_->store(index);
    return done;
  }

  SegmentStore<kCount>* store_ = nullptr;
  Polygons* polygons_ = nullptr;
};

}  // namespace spanline
