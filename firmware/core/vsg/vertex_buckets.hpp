#pragma once

#include "core/base/pool.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

// Vertices filed under the first line whose centre lies at or below them, two bytes each and two a line. A vertex is
// named by 1 + its number, so that 0 ends every list.
class VertexBuckets {
 public:
  VertexBuckets() = default;
  // One link a vertex, one bucket a line; `points` are the vertices on the screen.
  VertexBuckets(PoolRef<std::uint16_t> buckets, PoolRef<std::uint16_t> links, PoolRef<ScreenXY> points)
      : buckets_(buckets), links_(links), points_(points) {}

  // Empties the buckets of lines [top, bottom). Vertices above `top` belong to its bucket.
  void clear(std::int32_t top, std::int32_t bottom) {
    top_ = top;
    bottom_ = bottom;
    for (std::int32_t line = top; line < bottom; ++line) at(line) = kEmpty;
  }
  // Marks a vertex as not filed.
  void forget(std::uint16_t vertex) { links_[vertex] = kNotFiled; }
  // Files a vertex, once: true the first time. Those below the last line are never reached.
  bool file(std::uint16_t vertex) {
    std::uint16_t& link = links_[vertex];
    if (link != kNotFiled) return false;
    link = 0;
    const std::int32_t own = first_centre(points_[vertex].y);
    if (own >= bottom_) return true;
    std::uint16_t& bucket = at(own > top_ ? own : top_);
    link = bucket;
    bucket = vertex;
    return true;
  }
  bool is_empty(std::int32_t line) const { return buckets_[static_cast<std::uint32_t>(line - top_ + 1)] == kEmpty; }
  // The vertices of a line from left to right, as a list through next(): those that lie side by side in the mesh have
  // mostly been filed in this order or the reverse, which a hint turns into one look each. Those of the top line stay
  // as they are, since few of what lies above it has edges that reach it.
  std::uint16_t sorted(std::int32_t line);
  std::uint16_t next(std::uint16_t vertex) const { return links_[vertex]; }

 private:
  static constexpr std::uint16_t kEmpty = 0;
  static constexpr std::uint16_t kNotFiled = 0xffff;

  std::uint16_t& at(std::int32_t line) { return buckets_[static_cast<std::uint32_t>(line - top_ + 1)]; }

  PoolRef<std::uint16_t> buckets_, links_;
  PoolRef<ScreenXY> points_;
  std::int32_t top_ = 0, bottom_ = 0;
};

inline std::uint16_t VertexBuckets::sorted(std::int32_t line) {
  if (line == top_) return at(line);
  std::uint16_t first = 0, hint = 0;
  for (std::uint16_t vertex = at(line); vertex != 0;) {
    const std::uint16_t rest = links_[vertex];
    const std::int32_t x = points_[vertex].x;
    std::uint16_t before = hint != 0 && points_[hint].x <= x ? hint : std::uint16_t{0};
    for (std::uint16_t after = before == 0 ? first : links_[before]; after != 0 && points_[after].x < x;) {
      before = after;
      after = links_[after];
    }
    std::uint16_t& link = before == 0 ? first : links_[before];
    links_[vertex] = link;
    link = vertex;
    hint = vertex;
    vertex = rest;
  }
  return first;
}

}  // namespace spanline
