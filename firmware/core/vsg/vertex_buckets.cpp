#include "core/vsg/vertex_buckets.hpp"

namespace spanline {

void VertexBuckets::put(std::uint16_t vertex) {
  std::uint16_t& link = links_[vertex];
  link = kEnd;
  const std::int32_t own = first_centre(points_[vertex].y);
  if (own >= bottom_) return;
  std::uint16_t& bucket = at(own > top_ ? own : top_);
  link = bucket;
  bucket = vertex;
}

}  // namespace spanline
