// Implied edges (III.I): where two segments intersect on a line, remembered so that the next line can be sampled there.
#pragma once

#include "core/base/pool.hpp"

namespace spanline {

struct ImpliedEdge {
  std::uint16_t next;
  std::uint16_t segments[2];  // left one first
  std::int16_t column;        // where they crossed last
  std::int16_t step;          // columns a line
  std::uint16_t line;         // of that crossing
};

// Only ever a hint: a full pool drops it.
class ImpliedEdges {
 public:
  ImpliedEdges() = default;
  explicit ImpliedEdges(PoolRef<ImpliedEdge> blocks) : blocks_(blocks) {}

  void clear() {
    blocks_.clear();
    first_ = 0;
  }

  struct Prediction {
    std::int32_t column;  // where the crossing should be on the next line
    bool created, dropped;
  };
  // Notes that the segments cross at `column` of `line`.
  Prediction note(std::uint16_t left, std::uint16_t right, std::int32_t column, std::uint16_t line) {
    for (std::uint16_t at = first_; at != 0; at = blocks_[at].next) {
      ImpliedEdge& edge = blocks_[at];
      if (edge.segments[0] != left || edge.segments[1] != right || edge.line == line) continue;
      edge.step = static_cast<std::int16_t>(column - edge.column);
      edge.column = static_cast<std::int16_t>(column);
      edge.line = line;
      return {column + edge.step, false, false};
    }
    const std::uint16_t index = blocks_.take();
    if (index == 0) return {column, false, true};
    blocks_[index] = {first_, {left, right}, static_cast<std::int16_t>(column), 0, line};
    first_ = index;
    return {column, true, false};
  }

  // Frees those that were not seen on `line`.
  void sweep(std::uint16_t line) {
    std::uint16_t* link = &first_;
    while (*link != 0) {
      const std::uint16_t index = *link;
      if (blocks_[index].line == line) {
        link = &blocks_[index].next;
      } else {
        *link = blocks_[index].next;
        blocks_.give(index);
      }
    }
  }

  std::uint16_t used() const { return blocks_.used(); }

 private:
  FreeList<ImpliedEdge, &ImpliedEdge::next> blocks_;
  std::uint16_t first_ = 0;
};

}  // namespace spanline
