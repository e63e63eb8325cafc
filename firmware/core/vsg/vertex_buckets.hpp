#pragma once

#include "core/base/pool.hpp"
#include "core/geom/screen.hpp"
#include "core/vsg/x_list.hpp"

namespace spanline {

// Vertices filed under the first line whose centre lies at or below them, two bytes each and two a line. A vertex is
// named by 1 + its number, so that a link of 0 tells of one that is not to be filed; kEnd ends every list.
class VertexBuckets {
 public:
  static constexpr std::uint16_t kEnd = 0xffff;
  static constexpr std::uint32_t kMostVertices = kEnd - 1;

  VertexBuckets() = default;
  // One link a vertex, one bucket a line; `points` are the vertices on the screen.
  constexpr VertexBuckets(PoolRef<std::uint16_t> buckets, PoolRef<std::uint16_t> links, PoolRef<ScreenXY> points)
      : buckets_(buckets), links_(links), points_(points) {}

  // Empties the buckets of lines [top, bottom). Vertices above `top` belong to its bucket.
  void clear(std::int32_t top, std::int32_t bottom) {
    top_ = top;
    bottom_ = bottom;
    for (std::int32_t line = top; line < bottom; ++line) at(line) = kEnd;
  }
  bool is_empty(std::int32_t line) const { return buckets_[static_cast<std::uint32_t>(line - top_ + 1)] == kEnd; }
  // The vertices of one instance, by their numbers in its mesh.
  class Mesh {
   public:
    Mesh(VertexBuckets& buckets, std::uint32_t first)
        : buckets_(buckets), links_(&buckets.links_[first + 1]), first_(first + 1) {}

    // The first `count` are not marked.
    void forget(std::uint32_t count) {
      for (std::uint16_t *link = links_, *const end = link + count; link != end; ++link) *link = kNotMarked;
    }
    // To be filed.
    void mark(std::uint32_t vertex) { links_[vertex] = kEnd; }
    bool marked(std::uint32_t vertex) const { return links_[vertex] != kNotMarked; }
    // Files what is marked of the first `count`, for this frame or one more. Vertices below the last line are never
    // reached.
    void file(std::uint32_t count);

   private:
    VertexBuckets& buckets_;
    std::uint16_t* links_;
    std::uint32_t first_;
  };

  // The vertices of a line from left to right, as a list through links(). Those of the top line stay as they are, since
  // few of what lies above it has edges that reach it.
  std::uint16_t sorted(std::int32_t line);
  std::uint16_t* links() const { return links_.sink(); }

 private:
  static constexpr std::uint16_t kNotMarked = 0;

  std::uint16_t& at(std::int32_t line) { return buckets_[static_cast<std::uint32_t>(line - top_ + 1)]; }

  PoolRef<std::uint16_t> buckets_, links_;
  PoolRef<ScreenXY> points_;
  std::int32_t top_ = 0, bottom_ = 0;
};

inline std::uint16_t VertexBuckets::sorted(std::int32_t line) {
  struct Links {
    std::uint16_t* links;
    const ScreenXY* points;
    std::uint16_t next(std::uint16_t vertex) const { return links[vertex]; }
    void link(std::uint16_t vertex, std::uint16_t next) const { links[vertex] = next; }
    std::int32_t x(std::uint16_t vertex) const { return points[vertex].x; }
  };
  return line == top_ ? at(line) : sorted_by_x<kEnd>(Links{links_.sink(), points_.sink()}, at(line));
}

}  // namespace spanline
