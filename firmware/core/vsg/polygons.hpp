// The polygons that are alive, and the list of those that change on the line to come.
#pragma once

#include "core/scene/scene_view.hpp"
#include "core/vsg/blocks.hpp"

namespace spanline {

class Polygons {
 public:
  Polygons() = default;
  explicit Polygons(PoolRef<PolygonBlock> blocks) : blocks_(blocks) {}

  void clear() {
    blocks_.clear();
    changing_ = 0;
  }

  // Puts `polygon`, not yet active and without segments, into a block; 0 where none is left.
  std::uint16_t open(const PolygonBlock& polygon) {
    const std::uint16_t index = blocks_.take();
    if (index != 0) blocks_[index] = polygon;
    return index;
  }
  void close(std::uint16_t index) {
    blocks_[index].face = kNoFace;
    blocks_.give(index);
  }

  // Puts a polygon on the list of changing polygons, once.
  void change(std::uint16_t index) {
    PolygonBlock& polygon = blocks_[index];
    if ((polygon.flags & PolygonBlock::kActive) != 0) return;
    polygon.flags |= PolygonBlock::kActive;
    polygon.next_changing = changing_;
    changing_ = index;
  }
  // Takes the next changing polygon off its list; 0 at the end.
  std::uint16_t pop_changing() {
    const std::uint16_t index = changing_;
    if (index != 0) {
      changing_ = blocks_[index].next_changing;
      blocks_[index].flags &= static_cast<std::uint8_t>(~PolygonBlock::kActive);
    }
    return index;
  }
  // Walks the list; keeps a polygon on it where keep(index) says so.
  template <typename Keep>
  void filter_changing(const Keep& keep) {
    std::uint16_t* link = &changing_;
    while (*link != 0) {
      const std::uint16_t index = *link, next = blocks_[index].next_changing;
      if (keep(index)) {
        link = &blocks_[index].next_changing;
      } else {
        *link = next;
      }
    }
  }

  // The live polygon with the highest face number; 0 where none is alive.
  std::uint16_t last_face() const {
    std::uint16_t best = 0;
    for (std::uint16_t i = 1; i <= blocks_.ever_used(); ++i) {
      if (blocks_[i].face != kNoFace && (best == 0 || blocks_[best].before(blocks_[i]))) best = i;
    }
    return best;
  }

  PolygonBlock& operator[](std::uint16_t index) { return blocks_[index]; }
  const PolygonBlock& operator[](std::uint16_t index) const { return blocks_[index]; }
  std::uint16_t used() const { return blocks_.used(); }
  std::uint16_t capacity() const { return blocks_.capacity(); }

 private:
  FreeList<PolygonBlock, &PolygonBlock::first_segment> blocks_;
  std::uint16_t changing_ = 0;
};

}  // namespace spanline
