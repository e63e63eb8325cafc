// Implied edges (III.I): where two segments intersect on a line, remembered so that the next line can be sampled there.
#pragma once

#include "core/base/pool.hpp"

namespace spanline {

struct ImpliedEdge {
  std::uint16_t next;
  std::uint16_t segments[2];
  std::int16_t column;  // where they crossed last
  std::int16_t step;    // columns a line
  std::uint16_t line;   // of that crossing
  bool joins(std::uint16_t a, std::uint16_t b) const {
    return (segments[0] == a && segments[1] == b) || (segments[0] == b && segments[1] == a);
  }
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
  // Notes that two segments cross at `column` of `line`.
  Prediction note(std::uint16_t a, std::uint16_t b, std::int32_t column, std::uint16_t line) {
    for (std::uint16_t at = first_; at != 0; at = blocks_[at].next) {
      ImpliedEdge& edge = blocks_[at];
      if (!edge.joins(a, b)) continue;
      const std::int32_t lines = line - edge.line;
      if (lines != 0) edge.step = static_cast<std::int16_t>((column - edge.column) / lines);
      edge.column = static_cast<std::int16_t>(column);
      edge.line = line;
      return {column + edge.step, false, false};
    }
    const std::uint16_t index = blocks_.take();
    if (index == 0) return {column, false, true};
    blocks_[index] = {first_, {a, b}, static_cast<std::int16_t>(column), 0, line};
    first_ = index;
    return {column, true, false};
  }

  // Frees those that are not visible any more. A crossing that a real edge hides for a line or two is still the same
  // one.
  void sweep(std::uint16_t line) {
    constexpr std::int32_t kUnseenLines = 4;
    std::uint16_t* link = &first_;
    while (*link != 0) {
      const std::uint16_t index = *link;
      if (line - blocks_[index].line <= kUnseenLines) {
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
