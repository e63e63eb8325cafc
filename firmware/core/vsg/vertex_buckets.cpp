#include "core/vsg/vertex_buckets.hpp"

namespace spanline {

void VertexBuckets::Mesh::file(std::uint32_t count) {
  const ScreenXY* point = &buckets_.points_[first_] + count;
  const std::int32_t top = buckets_.top_, bottom = buckets_.bottom_;
  std::uint16_t* const buckets = &buckets_.at(top);
  for (std::uint16_t* link = links_ + count; link != links_;) {
    --link;
    --point;
    if (*link == kNotMarked) continue;
    const std::int32_t line = first_centre(point->y);
    if (line >= bottom) continue;
    std::uint16_t& bucket = buckets[line > top ? line - top : 0];
    *link = bucket;
    bucket = static_cast<std::uint16_t>(first_ + static_cast<std::uint32_t>(link - links_));
  }
}

}  // namespace spanline
