// The stored things of seed 1 (Fig. 4 and 5): segment block and polygon block, and the accessor that counts references.
#pragma once

#include <cstdint>

#include "core/vsg/edge.hpp"

namespace spanline {

// A segment: the surface of one polygon between two adjacent edges on a scan line (seed 1, III.A).
struct SegmentBlock {
  enum Flags : std::uint16_t {
    kListed = 1,    // in the X-sort list of the line to come
    kEntering = 2,  // in the list of segments that enter there
    kMoved = 4,     // the left half has changed since the block was sorted
  };
  std::uint16_t polygon;
  std::uint16_t next;          // X-sort list or entering list; also free storage
  std::uint16_t previous;      // X-sort list
  std::uint16_t polygon_next;  // polygon segment list
  std::uint16_t flags;
  SegmentHalf half[2];  // left, right

  std::int32_t left() const { return half[0].column; }
};

// An edge with its colours on its way into a segment list or from half to half.
struct PlacedEdge {
  SegmentHalf half;
  EdgeShade shade;
  friend bool operator<(const PlacedEdge& a, const PlacedEdge& b) {
    const std::strong_ordering by_place = order(a.half, b.half);
    return by_place != 0 ? by_place < 0 : a.shade < b.shade;
  }
};

// Gouraud's colours of both halves, in an array beside the segment blocks where the budget asks for it.
struct SegmentShade {
  EdgeShade half[2];
};

// Depth along a line: at(c) = at_zero + slope * c modulo 2^32, Q16.13, larger is nearer. A slope that does not fit
// belongs to a facet that covers one pixel of the line at most, where it does no harm.
struct DepthRamp {
  std::uint32_t at_zero = 0;
  std::uint32_t slope = 0;
  constexpr std::uint32_t at(std::int32_t column) const { return at_zero + slope * static_cast<std::uint32_t>(column); }
};

// A polygon that is alive: first line reached, last line not passed.
struct PolygonBlock {
  enum Flags : std::uint8_t {
    kActive = 1,    // in the list of changing polygons
    kTriangle = 2,  // depth by plane, made when first asked for
    kHasPlane = 4,
    kSettled = 16,   // changing, but its segment list is in order already
    kFinished = 32,  // both edges of its only segment ended on the line that was made last, and none is to come
    kGouraud = 8,
    kSmooth = 64,
    kAside = 128,  // surface detail or see-through: hides nothing
  };
  std::uint16_t face;           // kNoFace: block not in use
  std::uint16_t first_segment;  // polygon segment list; also free storage
  std::uint16_t next_changing;
  std::uint16_t waiting;  // edge blocks that name this polygon
  std::uint16_t payload;  // for shading: the flat colour
  std::uint8_t flags;
  DepthRamp ramp;      // a triangle's plane: for line 0,
  std::uint32_t down;  // and the step a line; of a facet that shares its face with others, as patches' do, its number

  // The order in which ties go and blocks are kept.
  bool before(const PolygonBlock& other) const { return face != other.face ? face < other.face : down < other.down; }
};

static_assert(sizeof(PolygonBlock) == 24 && sizeof(SegmentBlock) == 60);

// The one way to segment blocks. It counts references as the seed's machine would make them (the listing's Q(·,19) and
// Q(·,20)): a block is read whole into a register, looked at and changed there, and written back when another one is
// needed. So a visit costs a read, and a write where it changed something; the next visit of the same block in a row
// costs nothing.
template <bool kCount>
class SegmentStore {
 public:
  SegmentStore() = default;
  SegmentStore(PoolRef<SegmentBlock> blocks, PoolRef<SegmentShade> shades) : blocks_(blocks), shades_(shades) {}

  void clear() { blocks_.clear(); }
  // A fresh block needs no reading: it is made in the register.
  std::uint16_t take() {
    const std::uint16_t index = blocks_.take();
    if constexpr (kCount) {
      if (index != 0) {
        write_back();
        register_ = index;
        ++taken_;
      }
      if (blocks_.used() > most_) most_ = blocks_.used();
    }
    return index;
  }
  void give(std::uint16_t index) {
    if constexpr (kCount) {
      if (index == register_) dirty_ = false;
    }
    blocks_.give(index);
  }
  std::uint16_t used() const { return blocks_.used(); }
  std::uint16_t capacity() const { return blocks_.capacity(); }

  SegmentBlock& fetch(std::uint16_t index) {
    if constexpr (kCount) {
      if (index != register_) {
        write_back();
        register_ = index;
        ++references_;
      }
    }
    return blocks_[index];
  }
  // Marks a block as changed; one that is not in the register takes a reference of its own.
  void store(std::uint16_t index) {
    if constexpr (kCount) {
      if (index == register_) {
        dirty_ = true;
      } else {
        ++references_;
      }
    }
  }
  // A block whose content is at hand already: in the register, the last of the X-sort list, the visible segment of the
  // span.
  SegmentBlock& held(std::uint16_t index) { return blocks_[index]; }
  const SegmentBlock& held(std::uint16_t index) const { return blocks_[index]; }

  // A half with its colours. put() marks the block as moved where the left half changes, but counts nothing.
  PlacedEdge get(std::uint16_t index, unsigned side) const {
    return {blocks_[index].half[side], has_shades() ? shades_[index].half[side] : EdgeShade{}};
  }
  void put(std::uint16_t index, unsigned side, const PlacedEdge& edge) {
    blocks_[index].half[side] = edge.half;
    if (side == 0) blocks_[index].flags |= SegmentBlock::kMoved;
    if (has_shades()) shades_[index].half[side] = edge.shade;
  }

  bool has_shades() const { return shades_.capacity() != 0; }
  SegmentShade& shade(std::uint16_t index) const { return shades_[index]; }

  // The counters since they were cleared: references, blocks taken, most blocks at once.
  std::uint32_t references() const { return references_; }
  std::uint32_t taken() const { return taken_; }
  std::uint16_t most() const { return most_; }
  void clear_counters() {
    references_ = taken_ = 0;
    most_ = 0;
  }

 private:
  void write_back() {
    if (dirty_) ++references_;
    dirty_ = false;
  }

  FreeList<SegmentBlock, &SegmentBlock::next> blocks_;
  PoolRef<SegmentShade> shades_;
  std::uint32_t references_ = 0, taken_ = 0;
  std::uint16_t most_ = 0, register_ = 0;
  bool dirty_ = false;
};

}  // namespace spanline
