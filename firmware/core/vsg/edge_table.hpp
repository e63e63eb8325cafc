// The edge table: edges of live polygons that wait for their first line, in order of that line. An edge that two
// polygons share is one block, set up once.
#pragma once

#include "core/vsg/blocks.hpp"

namespace spanline {

class EdgeTable {
 public:
  EdgeTable() = default;
  explicit EdgeTable(PoolRef<EdgeBlock> blocks) : blocks_(blocks) {}

  void clear() {
    blocks_.clear();
    first_ = 0;
  }

  // Files an edge under its first line. False where no block is left.
  bool add(const ScreenEdge& edge, std::uint16_t polygon);

  // The next edge whose first line is `line`, out of the table; 0 where there is none. Give it back after use.
  std::uint16_t pop(std::int32_t line);
  const EdgeBlock& operator[](std::uint16_t index) const { return blocks_[index]; }
  void give(std::uint16_t index) { blocks_.give(index); }

  // Whether an edge of the polygon enters on `line`, the next line that edges are popped for.
  bool enters(std::uint16_t polygon, std::int32_t line) const;

  // Removes a polygon from every block.
  void forget(std::uint16_t polygon);

  std::uint16_t used() const { return blocks_.used(); }
  std::uint16_t capacity() const { return blocks_.capacity(); }

 private:
  FreeList<EdgeBlock, &EdgeBlock::next> blocks_;
  std::uint16_t first_ = 0;
};

}  // namespace spanline
